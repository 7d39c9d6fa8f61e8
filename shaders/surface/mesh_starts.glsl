// Where each tile's vertices and triangles are in the buffers of the path compute: the sums up to and with the tile.
#include "../shared/tiles.glsl"

#ifndef KNOTSPAN_STARTS_ACCESS
#define KNOTSPAN_STARTS_ACCESS readonly
#endif

layout(set = 0, binding = BINDING_MESH_GROUPS, scalar) buffer MeshGroupBuffer { uvec2 meshGroups[][2]; };
layout(set = 0, binding = BINDING_MESH_STARTS, scalar) KNOTSPAN_STARTS_ACCESS buffer StartBuffer { uvec2 ends[]; };

uint heldTiles() { return min(counters.tiles, frame.tileCapacity); }

// Vertices and triangles of a tile.
uvec2 itemsOf(uint tile)
{
    TileSize size = sizeOf(tiles[tile]);
    return uvec2(size.vertices, size.triangles);
}
