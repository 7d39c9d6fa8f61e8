// How a drawn grid is cut into tiles that the path can draw.
#include "../shared/tiles.glsl"

struct TileCut {
    uint u;      // rectangles along u
    uint v;
    uint rings;  // parts of the ring around them; the last of them is the whole grid where `whole`
    bool whole;
};

// Rectangles as even as it goes, along the side with more cells first.
uvec2 rectangles(uvec2 cells)
{
    uvec2 cut = uvec2(1u);
    for (;;) {
        uvec2 part = (cells + cut - 1u) / cut;
        bool wide = max(part.x, part.y) > frame.tileSide;
        bool full = (part.x + 1u) * (part.y + 1u) > frame.tileVertices || 2u * part.x * part.y > frame.tileTriangles;
        if (!wide && !full || max(part.x, part.y) == 1u)
            return cut;
        if (part.x >= part.y)
            ++cut.x;
        else
            ++cut.y;
    }
}

uint tileCount(TileCut cut)
{
    return cut.u * cut.v + cut.rings;
}

// The inside of a ringed grid starts a cell from its edges.
uvec2 cellsToCut(DrawnGrid grid)
{
    return frame.snap == SNAP_RING ? uvec2(grid.u - 2u, grid.v - 2u) : uvec2(grid.u, grid.v);
}

TileCut tileCut(DrawnGrid grid)
{
    if (frame.snap != SNAP_RING) {
        uvec2 cut = rectangles(uvec2(grid.u, grid.v));
        return TileCut(cut.x, cut.y, 0u, false);
    }
    bool inside = hasInside(grid);
    uint ring = outerSteps(grid) + innerSteps(grid);
    if (inside && (frame.flags & FRAME_WHOLE_TILES) != 0u) {
        uint vertices = insideVertices(grid) + outerSteps(grid);
        if (vertices <= frame.tileVertices && 2u * insideCells(grid) + ring <= frame.tileTriangles)
            return TileCut(0u, 0u, 1u, true);
    }
    uvec2 cut = inside && insideCells(grid) > 0u ? rectangles(cellsToCut(grid)) : uvec2(0u);
    return TileCut(cut.x, cut.y, (ring + frame.ringTriangles - 1u) / frame.ringTriangles, false);
}

// The first cell of part k of `parts`.
uint tileStart(uint cells, uint parts, uint k)
{
    uint start = k * cells / parts;
    return k < parts && (frame.flags & FRAME_EVEN_TILES) != 0u ? start & ~1u : start;
}

// Tile number k of a cut.
TileRecord tileOf(uint ksquad, DrawnGrid grid, TileCut cut, uint k)
{
    uint edges[4];
    for (uint side = 0u; side < 4u; ++side)
        edges[side] = grid.edges[side] | ((grid.divided >> side & 1u) != 0u ? TILE_DIVIDED : 0u);
    TileRecord tile = TileRecord(ksquad, 0u, 0u, grid.u | grid.v << 16u,
                                 uint[2](edges[0] | edges[1] << 16u, edges[2] | edges[3] << 16u));
    uint rectangleCount = cut.u * cut.v;
    if (cut.whole) {
        tile.grid |= TILE_WHOLE;
    } else if (k < rectangleCount) {
        uint offset = frame.snap == SNAP_RING ? 1u : 0u;
        uvec2 cells = cellsToCut(grid);
        uvec2 first = uvec2(tileStart(cells.x, cut.u, k / cut.v), tileStart(cells.y, cut.v, k % cut.v));
        uvec2 end = uvec2(tileStart(cells.x, cut.u, k / cut.v + 1u), tileStart(cells.y, cut.v, k % cut.v + 1u));
        tile.first = first.x + offset | first.y + offset << 16u;
        tile.cells = end.x - first.x | end.y - first.y << 16u;
    } else {
        RingPart part = ringPart(ksquad, grid, cut.rings, k - rectangleCount);
        tile.grid |= TILE_RING;
        tile.first = part.outer;
        tile.cells = part.outerSteps | part.innerSteps << 8u | part.inner << 16u;
    }
    return tile;
}
