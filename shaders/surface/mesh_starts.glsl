// Where each tile's vertices and cells are in the buffers of the path compute: the sums up to and with the tile.
#include "../shared/grid_scene.glsl"

#ifndef KNOTSPAN_STARTS_ACCESS
#define KNOTSPAN_STARTS_ACCESS readonly
#endif

layout(set = 0, binding = BINDING_MESH_GROUPS, scalar) buffer MeshGroupBuffer { uvec2 meshGroups[][2]; };
layout(set = 0, binding = BINDING_MESH_STARTS, scalar) KNOTSPAN_STARTS_ACCESS buffer StartBuffer { uvec2 ends[]; };

uint tileCount() { return min(counters.tiles, frame.tileCapacity); }

// Vertices and cells of a tile.
uvec2 sizeOf(uint tile)
{
    uvec2 cells = uvec2(tiles[tile].cells & 0xffffu, tiles[tile].cells >> 16u);
    return uvec2((cells.x + 1u) * (cells.y + 1u), cells.x * cells.y);
}
