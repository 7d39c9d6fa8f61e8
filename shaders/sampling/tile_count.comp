// Step 1 of the list of tiles: how many each visible KSQuad's grid is cut into, and their sum for each group of KSQuads.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "tile_cut.glsl"

layout(local_size_x = LIST_KSQUADS) in;

layout(set = 0, binding = BINDING_TILE_COUNTS, scalar) writeonly buffer CountBuffer { uint tileCounts[]; };
layout(set = 0, binding = BINDING_TILE_GROUPS, scalar) buffer GroupBuffer { uint groups[][2]; };

void main()
{
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    uint index = group * LIST_KSQUADS + gl_LocalInvocationID.x;
    if (index >= counters.visible)
        return;
    uint ksquad = visible[index];
    uint count = 0u;
    if ((grids[ksquad].alongU | grids[ksquad].alongV) != 0u)
        count = tileCount(tileCut(drawnGrid(ksquad, frame.snap)));
    tileCounts[index] = count;
    atomicAdd(groups[group][0], count);
}
