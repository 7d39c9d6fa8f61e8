// Step 1 of the buffers of the path compute: how many vertices and triangles each group of tiles has.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "mesh_starts.glsl"

layout(local_size_x = MESH_TILES) in;

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint tile = group * MESH_TILES + gl_LocalInvocationID.x;
    if (tile >= heldTiles())
        return;
    uvec2 size = itemsOf(tile);
    atomicAdd(meshGroups[group][0].x, size.x);
    atomicAdd(meshGroups[group][0].y, size.y);
}
