// Step 3 of the list of tiles: each tile to its place, in the order of the KSQuads.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_TILES_ACCESS writeonly
#include "tile_cut.glsl"

layout(local_size_x = LIST_KSQUADS) in;

layout(set = 0, binding = BINDING_TILE_COUNTS, scalar) readonly buffer CountBuffer { uint tileCounts[]; };
layout(set = 0, binding = BINDING_TILE_GROUPS, scalar) readonly buffer GroupBuffer { uint groups[][2]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = group * LIST_KSQUADS;
    uint index = first + gl_LocalInvocationID.x;
    if (index >= counters.visible || tileCounts[index] == 0u)
        return;
    uint place = groups[group][1];
    for (uint before = first; before < index; ++before)
        place += tileCounts[before];
    uint ksquad = visible[index];
    DrawnGrid grid = drawnGrid(ksquad, frame.snap);
    TileCut cut = tileCut(grid);
    for (uint k = 0u; k < tileCounts[index] && place + k < frame.tileCapacity; ++k)
        tiles[place + k] = tileOf(ksquad, grid, cut, k);
}
