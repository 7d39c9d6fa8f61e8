// Step 5 of the path compute: the two triangles of each cell into the index buffer.
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
    if (item >= counters.meshCells || counters.meshCells > frame.cellCapacity)
        return;
    uint index = tileOfItem(item, true);
    uint along = tiles[index].cells >> 16u;
    uvec2 start = index == 0u ? uvec2(0u) : ends[index - 1u];
    uint local = item - start.y;
    uint row = along + 1u;
    uint corner = start.x + local / along * row + local % along;
    // Cut from (1, 0) to (0, 1): SNAP_FALLING asks for it.
    uint six[6] = {corner, corner + row, corner + 1u, corner + row, corner + row + 1u, corner + 1u};
    for (uint k = 0u; k < 6u; ++k)
        indices[6u * item + k] = six[k];
}
