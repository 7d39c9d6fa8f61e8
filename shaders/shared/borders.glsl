// The grid that a KSQuad is drawn with, so that it meets its neighbours without a crack: the same text for every shader
// stage and for C++.
//
// Two ways. A path that can only draw regular grids draws one as fine as the finer of two opposite edges, and moves its
// border vertices to the edges' vertices, several to one where the edge has fewer. A path that can draw any triangles
// keeps what the KSQuad itself asks for inside, and joins it to its edges by a ring (ring.glsl).
#ifndef KNOTSPAN_BORDERS_GLSL
#define KNOTSPAN_BORDERS_GLSL

#include "edges.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

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
// None: the border's vertices are the edges', and a ring of triangles joins the cells inside to them.
#define SNAP_RING 3u

KNOTSPAN_SCENE_TEMPLATE
float shortestStep(KNOTSPAN_SOURCE BorderSide border)
{
    float shortest = 1.0f;
    for (uint k = 0u; k < border.flags >> BORDER_COUNT_SHIFT; ++k) {
        float length = KNOTSPAN_BORDER_PIECE(border.other + k).end - KNOTSPAN_BORDER_PIECE(border.other + k).start;
        KNOTSPAN_PRECISE float step =
            length / float(cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border.other + k, border.flags));
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
        uint least = max(1u, askedAlong KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE 4u * ksquad + side));
        least = snap == SNAP_RING ? least : max(edge, least);
        bool oversampled = false;
        if (innerNeighbour(place, ksquad, side) == NO_SIDE) {
            BorderSide border = KNOTSPAN_BORDER_SIDE(borderSideIndex(place, side));
            oversampled = KNOTSPAN_OVERSAMPLES(border.flags);
            if ((border.flags & BORDER_KIND) == BORDER_PIECES)
                grid.divided |= 1u << side;
            if ((border.flags & BORDER_KIND) == BORDER_PIECES && snap != SNAP_RING) {
                // So fine that each of the edge's vertices is the one that some border vertex goes to.
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
    bool moves = snap != SNAP_RING;
    if (moves && grid.u == 1u && min(grid.edges[0], grid.edges[1]) > 1u && max(grid.edges[0], grid.edges[1]) < grid.v)
        grid.u = 2u;
    if (moves && grid.v == 1u && min(grid.edges[2], grid.edges[3]) > 1u && max(grid.edges[2], grid.edges[3]) < grid.u)
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
        uint here = cellsOfPiece KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE piece, border.flags);
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

// Vertex (i, j) inside a KSQuad's drawn grid.
KNOTSPAN_INLINE GridVertex insideVertex(uint ksquad, DrawnGrid grid, uint i, uint j)
{
    KNOTSPAN_PRECISE KNOTSPAN_FLOAT2 t = KNOTSPAN_FLOAT2(float(i) / float(grid.u), float(j) / float(grid.v));
    return ownVertex(ksquad, t);
}

// Vertex (i, j) of a KSQuad's drawn grid whose border vertices go to those of the edges.
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
    if (side == NO_SIDE)
        return insideVertex(ksquad, grid, i, j);
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

// Of the points along a drawn grid's edges, each once, those of other KSQuads whose normals are the KSQuad's own: one
// evaluation for both.
KNOTSPAN_SCENE_TEMPLATE
uint sharedNormals(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid)
{
    SurfacePlace place = placeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad);
    uint count = 0u;
    for (uint k = 0u; k < 4u; ++k) {
        uint owner = cornerSource KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, k);
        if (owner / 4u != ksquad && sharesCorner KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, ksquad, k, owner))
            ++count;
        bool starts = (k & 1u) == 0u && innerNeighbour(place, ksquad, k) != NO_SIDE;
        if (starts && startsSmoothly KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, k == SIDE_START_U, k == SIDE_START_V))
            count += grid.edges[k] - 1u;
    }
    return count;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
