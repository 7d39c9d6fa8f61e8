// Step 3 of the buffers of the path compute: where each tile's vertices and triangles end.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_STARTS_ACCESS writeonly
#include "mesh_starts.glsl"

layout(local_size_x = MESH_TILES) in;

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint first = group * MESH_TILES;
    uint tile = first + gl_LocalInvocationID.x;
    if (tile >= heldTiles())
        return;
    uvec2 end = meshGroups[group][1];
    for (uint before = first; before <= tile; ++before)
        end += itemsOf(before);
    ends[tile] = end;
}
