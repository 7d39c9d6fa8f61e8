// Who lies along a KSQuad's sides, how many cells an edge gets, and where its vertices come from: the same text for
// every shader stage and for C++.
//
// Each KSQuad asks for a number of cells along each side (GridRecord); an edge gets the most that the sides along it
// ask for. Its vertices are points of its owner alone, so that all sides draw the same bits.
#ifndef KNOTSPAN_EDGES_GLSL
#define KNOTSPAN_EDGES_GLSL

#include "language.h"
#include "layouts.h"

// Stages and sides must agree to the bit, so nothing here may be contracted in one place and not in another.
#ifdef __cplusplus
#define KNOTSPAN_PRECISE
namespace knotspan::gpu {
#else
#define KNOTSPAN_PRECISE precise
#endif

#define NO_SIDE 0xffffffffu
#define FINEST_PIECE 32000.0f  // no piece is cut into more steps than that a side: cells are counted in 16 bits

// Where a KSQuad lies in its surface.
struct SurfacePlace {
    uint a;  // its span along u, counted from 0
    uint b;
    uint spansU;
    uint spansV;
    uint firstKsquad;
    uint firstBorder;
};

KNOTSPAN_SCENE_TEMPLATE
SurfacePlace placeOf(KNOTSPAN_SOURCE uint ksquad)
{
    SurfacePlace place;
    uint surface = KNOTSPAN_KSQUAD(ksquad).surface;
    place.firstKsquad = KNOTSPAN_SURFACE(surface).firstKsquad;
    place.spansU = KNOTSPAN_SURFACE(surface).spansU;
    place.spansV = KNOTSPAN_SURFACE(surface).spansV;
    place.firstBorder = KNOTSPAN_SURFACE(surface).firstBorder;
    place.a = (ksquad - place.firstKsquad) / place.spansV;
    place.b = (ksquad - place.firstKsquad) % place.spansV;
    return place;
}

// The KSQuad side on the other side of an edge inside the surface, or NO_SIDE at the surface's border.
KNOTSPAN_INLINE uint innerNeighbour(SurfacePlace place, uint ksquad, uint side)
{
    if (side == SIDE_START_U)
        return place.a > 0u ? 4u * (ksquad - place.spansV) + SIDE_END_U : NO_SIDE;
    if (side == SIDE_END_U)
        return place.a + 1u < place.spansU ? 4u * (ksquad + place.spansV) + SIDE_START_U : NO_SIDE;
    if (side == SIDE_START_V)
        return place.b > 0u ? 4u * (ksquad - 1u) + SIDE_END_V : NO_SIDE;
    return place.b + 1u < place.spansV ? 4u * (ksquad + 1u) + SIDE_START_V : NO_SIDE;
}

// The number of a border side: those of u = 0, then of u = 1, of v = 0 and of v = 1, each along its t.
KNOTSPAN_INLINE uint borderSideIndex(SurfacePlace place, uint side)
{
    if (side == SIDE_START_U)
        return place.firstBorder + place.b;
    if (side == SIDE_END_U)
        return place.firstBorder + place.spansV + place.b;
    return place.firstBorder + 2u * place.spansV + (side == SIDE_START_V ? 0u : place.spansU) + place.a;
}

// The number of a border corner, at lattice place (i, j), 0 <= i <= spansU: the rows v = 0 and v = 1 whole, then what
// is left of the columns u = 0 and u = 1.
KNOTSPAN_INLINE uint borderCornerIndex(SurfacePlace place, uint i, uint j)
{
    if (j == 0u)
        return place.firstBorder + i;
    if (j == place.spansV)
        return place.firstBorder + place.spansU + 1u + i;
    return place.firstBorder + 2u * (place.spansU + 1u) + (i == 0u ? 0u : place.spansV - 1u) + j - 1u;
}

// Where a vertex's position comes from, and what its parameters are.
struct GridVertex {
    KNOTSPAN_FLOAT2 t;        // in the KSQuad itself
    uint source;              // the KSQuad whose point it is
    KNOTSPAN_FLOAT2 sourceT;  // there
    bool sharesNormal;        // its normal and weight there are the KSQuad's own, too; else those are at t
};

KNOTSPAN_INLINE KNOTSPAN_FLOAT2 cornerParameters(uint corner)
{
    return KNOTSPAN_FLOAT2(float(corner & 1u), float(corner >> 1u & 1u));
}

// The point at `t` along a side.
KNOTSPAN_INLINE KNOTSPAN_FLOAT2 sideParameters(uint side, float t)
{
    if (side < SIDE_START_V)
        return KNOTSPAN_FLOAT2(side == SIDE_END_U ? 1.0f : 0.0f, t);
    return KNOTSPAN_FLOAT2(t, side == SIDE_END_V ? 1.0f : 0.0f);
}

// The least 4 ksquad + corner at lattice place (i, j) of a surface.
KNOTSPAN_INLINE uint leastCorner(SurfacePlace place, uint i, uint j)
{
    uint before = place.firstKsquad + (i > 0u ? (i - 1u) * place.spansV : 0u) + (j > 0u ? j - 1u : 0u);
    return 4u * before + (i > 0u ? 1u : 0u) + (j > 0u ? 2u : 0u);
}

// 4 ksquad + corner that owns a corner's point.
KNOTSPAN_SCENE_TEMPLATE
uint cornerSource(KNOTSPAN_SOURCE SurfacePlace place, uint corner)
{
    uint i = place.a + (corner & 1u);
    uint j = place.b + (corner >> 1u & 1u);
    if (i > 0u && i < place.spansU && j > 0u && j < place.spansV)
        return leastCorner(place, i, j);
    return KNOTSPAN_BORDER_CORNER(borderCornerIndex(place, i, j));
}

// Whether a KSQuad's surface is smooth across the knot lines that it starts with along u and along v, those that are asked
// for: one normal for both sides. SpanTablePool says so in front of the spans' matrices.
KNOTSPAN_SCENE_TEMPLATE
bool startsSmoothly(KNOTSPAN_SOURCE uint ksquad, bool alongU, bool alongV)
{
    uint surface = KNOTSPAN_KSQUAD(ksquad).surface;
    uint orderU = KNOTSPAN_SURFACE(surface).degreeU + 1u;
    uint orderV = KNOTSPAN_SURFACE(surface).degreeV + 1u;
    bool smoothly = true;
    if (alongU)
        smoothly = KNOTSPAN_TABLE(KNOTSPAN_KSQUAD(ksquad).spanU - orderU * orderU - 1u) != 0.0f;
    if (alongV)
        smoothly = smoothly && KNOTSPAN_TABLE(KNOTSPAN_KSQUAD(ksquad).spanV - orderV * orderV - 1u) != 0.0f;
    return smoothly;
}

// Whether `owner`, 4 ksquad + corner, that a corner's point comes from, has its normal, too: where it is the same corner of
// the same surface, seen from a KSQuad before.
KNOTSPAN_SCENE_TEMPLATE
bool sharesCorner(KNOTSPAN_SOURCE SurfacePlace place, uint ksquad, uint corner, uint owner)
{
    uint i = place.a + (corner & 1u);
    uint j = place.b + (corner >> 1u & 1u);
    if (owner != leastCorner(place, i, j))
        return false;
    bool acrossU = i > 0u && (corner & 1u) == 0u;
    bool acrossV = j > 0u && (corner & 2u) == 0u;
    return startsSmoothly KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, acrossU, acrossV);
}

KNOTSPAN_INLINE uint cellsAlong(GridRecord grid, uint side)
{
    uint both = side < SIDE_START_V ? grid.alongV : grid.alongU;
    return (side & 1u) == 0u ? both & 0xffffu : both >> 16u;
}

KNOTSPAN_INLINE GridRecord gridRecord(uint startU, uint endU, uint startV, uint endV)
{
    GridRecord grid;
    grid.alongV = startU | endU << 16u;
    grid.alongU = startV | endV << 16u;
    return grid;
}

KNOTSPAN_SCENE_TEMPLATE
uint askedAlong(KNOTSPAN_SOURCE uint side)
{
    return cellsAlong(KNOTSPAN_GRID(side / 4u), side & 3u);
}

// Cells of a piece of a divided side with these flags.
KNOTSPAN_SCENE_TEMPLATE
uint cellsOfPiece(KNOTSPAN_SOURCE uint piece, KNOTSPAN_UNUSED uint flags)
{
    uint first = KNOTSPAN_BORDER_PIECE(piece).firstUse;
    uint count = KNOTSPAN_BORDER_PIECE(piece).useCount;
    uint cells = 1u;
    float least = 1.0f;
    for (uint k = 0u; k < count; ++k) {
        float share = KNOTSPAN_BORDER_USE(first + k).share;
        KNOTSPAN_PRECISE float asked =
            share * float(askedAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE KNOTSPAN_BORDER_USE(first + k).side));
        cells = max(cells, uint(ceil(asked)));
        least = min(least, share);
    }
    cells = KNOTSPAN_OVERSAMPLES(flags) ? 2u * cells : cells;
    return min(cells, max(uint(FINEST_PIECE * least), 1u));
}

// Cells along the edge at a side of a KSQuad. A collapsed side says 0: it takes as many as the grid has.
KNOTSPAN_SCENE_TEMPLATE
uint edgeCells(KNOTSPAN_SOURCE SurfacePlace place, uint ksquad, uint side)
{
    uint cells = max(1u, askedAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE 4u * ksquad + side));
    uint inner = innerNeighbour(place, ksquad, side);
    if (inner != NO_SIDE)
        return max(cells, askedAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE inner));
    BorderSide border = KNOTSPAN_BORDER_SIDE(borderSideIndex(place, side));
    uint kind = border.flags & BORDER_KIND;
    if (kind == BORDER_COLLAPSED)
        return 0u;
    if (kind == BORDER_PIECES) {
        cells = 0u;
        for (uint k = 0u; k < border.flags >> BORDER_COUNT_SHIFT; ++k)
            cells += cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border.other + k, border.flags);
        return cells;
    }
    if (kind == BORDER_WHOLE)
        cells = max(cells, askedAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border.other));
    return KNOTSPAN_OVERSAMPLES(border.flags) ? 2u * cells : cells;
}

KNOTSPAN_INLINE GridVertex vertexFrom(KNOTSPAN_FLOAT2 t, uint source, KNOTSPAN_FLOAT2 sourceT)
{
    GridVertex vertex;
    vertex.t = t;
    vertex.source = source;
    vertex.sourceT = sourceT;
    vertex.sharesNormal = false;
    return vertex;
}

// A point of the KSQuad itself.
KNOTSPAN_INLINE GridVertex ownVertex(uint ksquad, KNOTSPAN_FLOAT2 t)
{
    GridVertex vertex = vertexFrom(t, ksquad, t);
    vertex.sharesNormal = true;
    return vertex;
}

// Where vertex k of a divided side is: of a piece, at step k of its cells.
struct PieceStep {
    uint piece;
    uint step;
    uint cells;
};

KNOTSPAN_SCENE_TEMPLATE
PieceStep pieceStep(KNOTSPAN_SOURCE BorderSide border, uint k)
{
    uint last = border.other + (border.flags >> BORDER_COUNT_SHIFT) - 1u;
    uint piece = border.other;
    uint cells = cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE piece, border.flags);
    while (k >= cells && piece < last) {
        k -= cells;
        ++piece;
        cells = cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE piece, border.flags);
    }
    PieceStep at;
    at.piece = piece;
    at.step = k;
    at.cells = cells;
    return at;
}

// Its t along the side.
KNOTSPAN_INLINE float pieceT(BorderPiece piece, PieceStep at)
{
    KNOTSPAN_PRECISE float t = piece.start + (piece.end - piece.start) * (float(at.step) / float(at.cells));
    return t;
}

// Vertex k along a divided side, not at its ends.
KNOTSPAN_SCENE_TEMPLATE
GridVertex pieceVertex(KNOTSPAN_SOURCE uint side, BorderSide border, uint k)
{
    PieceStep at = pieceStep KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border, k);
    BorderPiece along = KNOTSPAN_BORDER_PIECE(at.piece);
    if (at.step == 0u && along.corner != NO_CORNER)
        return vertexFrom(sideParameters(side, along.start), along.corner / 4u, cornerParameters(along.corner & 3u));
    // From the owner's start on, whichever way this side runs, so that the bits agree.
    bool reversed = along.ownerStart > along.ownerEnd;
    float low = reversed ? along.ownerEnd : along.ownerStart;
    float high = reversed ? along.ownerStart : along.ownerEnd;
    KNOTSPAN_PRECISE float share = float(reversed ? at.cells - at.step : at.step) / float(at.cells);
    KNOTSPAN_PRECISE float there = low + (high - low) * share;
    return vertexFrom(sideParameters(side, pieceT(along, at)), along.owner / 4u,
                      sideParameters(along.owner & 3u, there));
}

// Vertex k of 0 .. cells along the edge at a side; `cells` is edgeCells(), of a collapsed side the grid's.
KNOTSPAN_SCENE_TEMPLATE
GridVertex edgeVertex(KNOTSPAN_SOURCE SurfacePlace place, uint ksquad, uint side, uint k, uint cells)
{
    bool alongV = side < SIDE_START_V;
    if (k == 0u || k == cells) {
        uint end = k == 0u ? 0u : 1u;
        uint corner = alongV ? (side & 1u) + 2u * end : end + 2u * (side & 1u);
        uint owner = cornerSource KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, corner);
        GridVertex vertex = vertexFrom(cornerParameters(corner), owner / 4u, cornerParameters(owner & 3u));
        vertex.sharesNormal =
            sharesCorner KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, ksquad, corner, owner);
        return vertex;
    }
    KNOTSPAN_PRECISE float t = float(k) / float(cells);
    KNOTSPAN_FLOAT2 own = sideParameters(side, t);
    uint inner = innerNeighbour(place, ksquad, side);
    if (inner != NO_SIDE) {
        // The side before the edge owns it.
        if ((side & 1u) == 1u)
            return ownVertex(ksquad, own);
        GridVertex vertex = vertexFrom(own, inner / 4u, sideParameters(inner & 3u, t));
        vertex.sharesNormal =
            startsSmoothly KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, alongV, !alongV);
        return vertex;
    }
    BorderSide border = KNOTSPAN_BORDER_SIDE(borderSideIndex(place, side));
    uint kind = border.flags & BORDER_KIND;
    if (kind == BORDER_PIECES)
        return pieceVertex KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE side, border, k);
    if (kind == BORDER_COLLAPSED) {
        uint owner = cornerSource KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place,
                                                      alongV ? (side & 1u) : 2u * (side & 1u));
        return vertexFrom(own, owner / 4u, cornerParameters(owner & 3u));
    }
    if (kind == BORDER_WHOLE && (border.flags & BORDER_OWNER) == 0u) {
        bool reversed = (border.flags & BORDER_REVERSED) != 0u;
        KNOTSPAN_PRECISE float there = float(reversed ? cells - k : k) / float(cells);
        return vertexFrom(own, border.other / 4u, sideParameters(border.other & 3u, there));
    }
    return ownVertex(ksquad, own);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
