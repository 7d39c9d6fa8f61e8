// Step 5 of the path compute: each triangle into the index buffer.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "mesh_starts.glsl"
#include "mesh_item.glsl"

layout(local_size_x = MESH_ITEMS) in;

layout(set = 0, binding = BINDING_INDICES, scalar) writeonly buffer IndexBuffer { uint indices[]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint item = group * MESH_ITEMS + gl_LocalInvocationID.x;
    if (item >= counters.meshTriangles || counters.meshTriangles > frame.triangleCapacity)
        return;
    uint index = tileOfItem(item, true);
    uvec2 start = index == 0u ? uvec2(0u) : ends[index - 1u];
    uvec3 corners = start.x + tileTriangle(tiles[index], item - start.y);
    for (uint k = 0u; k < 3u; ++k)
        indices[3u * item + k] = corners[k];
}
