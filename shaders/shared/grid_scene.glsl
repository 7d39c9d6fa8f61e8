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

DrawnGrid gridOf(TileRecord tile)
{
    DrawnGrid grid;
    grid.u = tile.grid & 0x7fffu;
    grid.v = tile.grid >> 16u & 0x7fffu;
    grid.divided = 0u;
    for (uint side = 0u; side < 4u; ++side) {
        uint edge = tile.edges[side / 2u] >> 16u * (side & 1u) & 0xffffu;
        grid.edges[side] = edge & ~TILE_DIVIDED;
        grid.divided |= (edge & TILE_DIVIDED) != 0u ? 1u << side : 0u;
    }
    return grid;
}

#endif
