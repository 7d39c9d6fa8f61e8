// One level of the depth pyramid: counters.pyramidLevel, from the one below.
#version 460
#extension GL_GOOGLE_include_directive : require

#define KNOTSPAN_PYRAMID_ACCESS
#include "depth_pyramid.glsl"

layout(local_size_x = PYRAMID_TEXELS) in;

void main()
{
    uint index = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * PYRAMID_TEXELS + gl_LocalInvocationID.x;
    uint level = counters.pyramidLevel;
    uvec2 size = levelSize(level);
    if (index >= size.x * size.y)
        return;
    uvec2 below = levelSize(level - 1u);
    uint from = levelStart(level - 1u);
    uvec2 first = 2u * uvec2(index % size.x, index / size.x);
    uvec2 last = min(first + 1u, below - 1u);
    float farthest = 1.0;
    for (uint y = first.y; y <= last.y; ++y)
        for (uint x = first.x; x <= last.x; ++x)
            farthest = min(farthest, depths[from + y * below.x + x]);
    depths[levelStart(level) + index] = farthest;
}
