// The grid that a KSQuad is drawn with, and where its vertices come from, so that it meets its neighbours without a
// crack: the same text for every shader stage and for C++.
//
// Each KSQuad asks for a number of cells along each side (GridRecord); an edge gets the most that the sides along it
// ask for. The drawn grid is regular, with as many cells as the finer of two opposite edges. Its border vertices are
// moved to the edges' vertices, several to one where the edge has fewer. An edge's vertices are points of its owner
// alone, so that all sides draw the same bits.
#ifndef KNOTSPAN_BORDERS_GLSL
#define KNOTSPAN_BORDERS_GLSL

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

// Where a vertex's position comes from, and what its parameters are. The normal is always the KSQuad's own.
struct GridVertex {
    KNOTSPAN_FLOAT2 t;        // in the KSQuad itself
    uint source;              // the KSQuad whose point it is
    KNOTSPAN_FLOAT2 sourceT;  // there
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

// 4 ksquad + corner that owns a corner's point.
KNOTSPAN_SCENE_TEMPLATE
uint cornerSource(KNOTSPAN_SOURCE SurfacePlace place, uint corner)
{
    uint i = place.a + (corner & 1u);
    uint j = place.b + (corner >> 1u & 1u);
    if (i > 0u && i < place.spansU && j > 0u && j < place.spansV)
        return 4u * (place.firstKsquad + (i - 1u) * place.spansV + j - 1u) + 3u;
    return KNOTSPAN_BORDER_CORNER(borderCornerIndex(place, i, j));
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

// Cells of a piece of a divided side.
KNOTSPAN_SCENE_TEMPLATE
uint cellsOfPiece(KNOTSPAN_SOURCE uint piece)
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
    cells = KNOTSPAN_OVERSAMPLES(BORDER_PIECES) ? 2u * cells : cells;
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
            cells += cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border.other + k);
        return cells;
    }
    if (kind == BORDER_WHOLE)
        cells = max(cells, askedAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border.other));
    return KNOTSPAN_OVERSAMPLES(kind) ? 2u * cells : cells;
}

KNOTSPAN_INLINE GridVertex vertexFrom(KNOTSPAN_FLOAT2 t, uint source, KNOTSPAN_FLOAT2 sourceT)
{
    GridVertex vertex;
    vertex.t = t;
    vertex.source = source;
    vertex.sourceT = sourceT;
    return vertex;
}

// Vertex k of the `cells` along a divided side, not at its ends.
KNOTSPAN_SCENE_TEMPLATE
GridVertex pieceVertex(KNOTSPAN_SOURCE uint side, BorderSide border, uint k)
{
    uint piece = border.other;
    uint cells = cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE piece);
    while (k >= cells) {
        k -= cells;
        ++piece;
        cells = cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE piece);
    }
    BorderPiece along = KNOTSPAN_BORDER_PIECE(piece);
    if (k == 0u && along.corner != NO_CORNER)
        return vertexFrom(sideParameters(side, along.start), along.corner / 4u, cornerParameters(along.corner & 3u));
    // From the owner's start on, whichever way this side runs, so that the bits agree.
    bool reversed = along.ownerStart > along.ownerEnd;
    float low = reversed ? along.ownerEnd : along.ownerStart;
    float high = reversed ? along.ownerStart : along.ownerEnd;
    KNOTSPAN_PRECISE float step = float(reversed ? cells - k : k) / float(cells);
    KNOTSPAN_PRECISE float there = low + (high - low) * step;
    KNOTSPAN_PRECISE float own = along.start + (along.end - along.start) * (float(k) / float(cells));
    return vertexFrom(sideParameters(side, own), along.owner / 4u, sideParameters(along.owner & 3u, there));
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
        return vertexFrom(cornerParameters(corner), owner / 4u, cornerParameters(owner & 3u));
    }
    KNOTSPAN_PRECISE float t = float(k) / float(cells);
    KNOTSPAN_FLOAT2 own = sideParameters(side, t);
    uint inner = innerNeighbour(place, ksquad, side);
    if (inner != NO_SIDE) {
        // The side before the edge owns it.
        if ((side & 1u) == 1u)
            return vertexFrom(own, ksquad, own);
        return vertexFrom(own, inner / 4u, sideParameters(inner & 3u, t));
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
    return vertexFrom(own, ksquad, own);
}

// A KSQuad's grid as it is drawn.
struct DrawnGrid {
    uint u;         // cells
    uint v;
    uint edges[4];  // cells along the edge at each side
    uint divided;   // a bit for each side that is BORDER_PIECES: its vertices are not evenly spaced
};

// How border vertices of the grid go to those of an edge. FALLING: downwards on the sides u = 0 and v = 0, upwards on the
// others. Where cells are cut from (1, 0) to (0, 1), every triangle then fits into a box of the parameters no larger than a
// cell of the coarser edge, which is what the bound of screen_error.glsl asks for. NEAREST: to the nearest; that holds
// whichever way cells are cut, but only where the edge has one cell, as many as the grid or at most half as many.
#define SNAP_FALLING 0u
#define SNAP_NEAREST 1u
// As FALLING, and the grid has twice as many cells as an edge that is not oversampled: a grid to halve.
#define SNAP_HALVES 2u

KNOTSPAN_SCENE_TEMPLATE
float shortestStep(KNOTSPAN_SOURCE BorderSide border)
{
    float shortest = 1.0f;
    for (uint k = 0u; k < border.flags >> BORDER_COUNT_SHIFT; ++k) {
        float length = KNOTSPAN_BORDER_PIECE(border.other + k).end - KNOTSPAN_BORDER_PIECE(border.other + k).start;
        KNOTSPAN_PRECISE float step =
            length / float(cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border.other + k));
        shortest = min(shortest, step);
    }
    return shortest;
}

KNOTSPAN_INLINE uint evenCells(uint cells, uint edge, bool divided, uint snap)
{
    return snap == SNAP_NEAREST && !divided && edge > 1u && cells != edge && cells < 2u * edge ? 2u * edge : cells;
}

KNOTSPAN_SCENE_TEMPLATE
DrawnGrid drawnGrid(KNOTSPAN_SOURCE uint ksquad, uint snap)
{
    SurfacePlace place = placeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad);
    DrawnGrid grid;
    grid.divided = 0u;
    uint cells[2];  // along v, along u
    cells[0] = 1u;
    cells[1] = 1u;
    for (uint side = 0u; side < 4u; ++side) {
        uint edge = edgeCells KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, ksquad, side);
        grid.edges[side] = edge;
        uint least = max(edge, askedAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE 4u * ksquad + side));
        bool oversampled = false;
        if (innerNeighbour(place, ksquad, side) == NO_SIDE) {
            BorderSide border = KNOTSPAN_BORDER_SIDE(borderSideIndex(place, side));
            oversampled = KNOTSPAN_OVERSAMPLES(border.flags & BORDER_KIND);
            if ((border.flags & BORDER_KIND) == BORDER_PIECES) {
                // So fine that each of the edge's vertices is the one that some border vertex goes to.
                grid.divided |= 1u << side;
                float step = shortestStep KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border);
                KNOTSPAN_PRECISE float steps = (snap == SNAP_NEAREST ? 2.02f : 1.01f) / step;
                least = uint(ceil(steps));
            }
        }
        if (snap == SNAP_HALVES && !oversampled)
            least *= 2u;
        cells[side / 2u] = max(cells[side / 2u], least);
    }
    for (uint side = 0u; side < 4u; ++side) {
        uint other = side ^ 1u;
        bool divided = (grid.divided >> side & 1u) != 0u;
        cells[side / 2u] = evenCells(cells[side / 2u], grid.edges[side], divided, snap);
        divided = (grid.divided >> other & 1u) != 0u;
        cells[side / 2u] = evenCells(cells[side / 2u], grid.edges[other], divided, snap);
    }
    grid.v = cells[0];
    grid.u = cells[1];
    // Two borders that both move want a row between them that does not.
    if (grid.u == 1u && min(grid.edges[0], grid.edges[1]) > 1u && max(grid.edges[0], grid.edges[1]) < grid.v)
        grid.u = 2u;
    if (grid.v == 1u && min(grid.edges[2], grid.edges[3]) > 1u && max(grid.edges[2], grid.edges[3]) < grid.u)
        grid.v = 2u;
    for (uint side = 0u; side < 4u; ++side)
        if (grid.edges[side] == 0u)
            grid.edges[side] = side < SIDE_START_V ? grid.v : grid.u;
    return grid;
}

// k * edge / cells, downwards, upwards or to the nearest.
KNOTSPAN_INLINE uint snapped(uint k, uint cells, uint edge, bool endSide, uint snap)
{
    if (snap == SNAP_NEAREST)
        return (2u * k * edge + cells) / (2u * cells);
    return endSide ? (k * edge + cells - 1u) / cells : k * edge / cells;
}

// The same along a divided side, by its vertices' t.
KNOTSPAN_SCENE_TEMPLATE
uint snappedToPieces(KNOTSPAN_SOURCE BorderSide border, uint k, uint cells, bool endSide, uint snap)
{
    if (k == 0u)
        return 0u;
    KNOTSPAN_PRECISE float t = float(k) / float(cells);
    uint before = 0u;
    uint last = border.other + (border.flags >> BORDER_COUNT_SHIFT) - 1u;
    for (uint piece = border.other;; ++piece) {
        uint here = cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE piece);
        float start = KNOTSPAN_BORDER_PIECE(piece).start;
        float end = KNOTSPAN_BORDER_PIECE(piece).end;
        if (k == cells && piece == last)
            return before + here;
        if (t < end || piece == last) {
            KNOTSPAN_PRECISE float steps = (t - start) / (end - start) * float(here);
            float whole = snap == SNAP_NEAREST ? floor(steps + 0.5f) : (endSide ? ceil(steps) : floor(steps));
            return before + min(uint(max(whole, 0.0f)), here);
        }
        before += here;
    }
}

// Vertex (i, j) of a KSQuad's drawn grid.
KNOTSPAN_SCENE_TEMPLATE
GridVertex gridVertex(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid, uint i, uint j, uint snap)
{
    uint side = NO_SIDE;
    if (i == 0u)
        side = SIDE_START_U;
    else if (i == grid.u)
        side = SIDE_END_U;
    else if (j == 0u)
        side = SIDE_START_V;
    else if (j == grid.v)
        side = SIDE_END_V;
    if (side == NO_SIDE) {
        KNOTSPAN_PRECISE KNOTSPAN_FLOAT2 t = KNOTSPAN_FLOAT2(float(i) / float(grid.u), float(j) / float(grid.v));
        return vertexFrom(t, ksquad, t);
    }
    SurfacePlace place = placeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad);
    uint k = side < SIDE_START_V ? j : i;
    uint cells = side < SIDE_START_V ? grid.v : grid.u;
    if ((grid.divided >> side & 1u) != 0u)
        k = snappedToPieces KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE KNOTSPAN_BORDER_SIDE(borderSideIndex(place, side)), k,
                                               cells, (side & 1u) == 1u, snap);
    else if (cells != grid.edges[side])
        k = snapped(k, cells, grid.edges[side], (side & 1u) == 1u, snap);
    return edgeVertex KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, ksquad, side, k, grid.edges[side]);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
