// The bound scene with the grids of its KSQuads: for the stages that choose them and those that draw them.
#ifndef KNOTSPAN_GRID_SCENE_GLSL
#define KNOTSPAN_GRID_SCENE_GLSL

#include "counters.glsl"

#ifndef KNOTSPAN_GRIDS_ACCESS
#define KNOTSPAN_GRIDS_ACCESS readonly
#endif
#ifndef KNOTSPAN_TILES_ACCESS
#define KNOTSPAN_TILES_ACCESS readonly
#endif

layout(set = 0, binding = BINDING_VISIBLE, scalar) readonly buffer VisibleBuffer { uint visible[]; };
layout(set = 0, binding = BINDING_BORDER_SIDES, scalar) readonly buffer BorderSideBuffer { BorderSide borderSides[]; };
layout(set = 0, binding = BINDING_BORDER_CORNERS, scalar) readonly buffer BorderCornerBuffer { uint borderCorners[]; };
layout(set = 0, binding = BINDING_BORDER_PIECES, scalar) readonly buffer BorderPieceBuffer { BorderPiece borderPieces[]; };
layout(set = 0, binding = BINDING_BORDER_USES, scalar) readonly buffer BorderUseBuffer { BorderUse borderUses[]; };
layout(set = 0, binding = BINDING_GRIDS, scalar) KNOTSPAN_GRIDS_ACCESS buffer GridBuffer { GridRecord grids[]; };
layout(set = 0, binding = BINDING_TILES, scalar) KNOTSPAN_TILES_ACCESS buffer TileBuffer { TileRecord tiles[]; };

#include "borders.glsl"

// How a drawn grid is cut into tiles that the path can draw: as evenly as it goes, along the side with more cells first.
struct TileCut {
    uint u;  // tiles along u
    uint v;
};

TileCut tileCut(DrawnGrid grid)
{
    TileCut cut = TileCut(1u, 1u);
    for (;;) {
        uint u = (grid.u + cut.u - 1u) / cut.u;
        uint v = (grid.v + cut.v - 1u) / cut.v;
        bool wide = max(u, v) > frame.tileSide;
        bool full = (u + 1u) * (v + 1u) > frame.tileVertices || 2u * u * v > frame.tileTriangles;
        if (!wide && !full || max(u, v) == 1u)
            return cut;
        if (u >= v)
            ++cut.u;
        else
            ++cut.v;
    }
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
    uint a = k / cut.v;
    uint b = k % cut.v;
    uint firstU = tileStart(grid.u, cut.u, a);
    uint firstV = tileStart(grid.v, cut.v, b);
    uint edges[4];
    for (uint side = 0u; side < 4u; ++side)
        edges[side] = grid.edges[side] | ((grid.divided >> side & 1u) != 0u ? TILE_DIVIDED : 0u);
    return TileRecord(ksquad, firstU | firstV << 16u,
                      tileStart(grid.u, cut.u, a + 1u) - firstU | tileStart(grid.v, cut.v, b + 1u) - firstV << 16u,
                      grid.u | grid.v << 16u, uint[2](edges[0] | edges[1] << 16u, edges[2] | edges[3] << 16u));
}

DrawnGrid gridOf(TileRecord tile)
{
    DrawnGrid grid;
    grid.u = tile.grid & 0xffffu;
    grid.v = tile.grid >> 16u;
    grid.divided = 0u;
    for (uint side = 0u; side < 4u; ++side) {
        uint edge = tile.edges[side / 2u] >> 16u * (side & 1u) & 0xffffu;
        grid.edges[side] = edge & ~TILE_DIVIDED;
        grid.divided |= (edge & TILE_DIVIDED) != 0u ? 1u << side : 0u;
    }
    return grid;
}

// Vertex number k of a tile's (cells.u + 1) (cells.v + 1), u outer.
GridVertex tileVertex(TileRecord tile, uint k)
{
    uint row = (tile.cells >> 16u) + 1u;
    return gridVertex(tile.ksquad, gridOf(tile), (tile.first & 0xffffu) + k / row, (tile.first >> 16u) + k % row,
                      frame.snap);
}

#endif
