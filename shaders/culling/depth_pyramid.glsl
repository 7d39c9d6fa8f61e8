// The farthest depths of the picture so far, in levels: level 0 is each pixel's, of each other a texel is that of up to
// 2 x 2 below it. Depth is reversed, so the farthest is the least.
#ifndef KNOTSPAN_DEPTH_PYRAMID_GLSL
#define KNOTSPAN_DEPTH_PYRAMID_GLSL

#include "../shared/counters.glsl"

#ifndef KNOTSPAN_PYRAMID_ACCESS
#define KNOTSPAN_PYRAMID_ACCESS readonly
#endif
layout(set = 0, binding = BINDING_DEPTHS, scalar) KNOTSPAN_PYRAMID_ACCESS buffer DepthBuffer { float depths[]; };

uvec2 levelSize(uint level) { return (uvec2(frame.pixels) + (1u << level) - 1u) >> level; }

uint levelStart(uint level)
{
    uint start = 0u;
    for (uint below = 0u; below < level; ++below)
        start += levelSize(below).x * levelSize(below).y;
    return start;
}

#endif
