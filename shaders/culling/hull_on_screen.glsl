// Where a KSQuad can be in the picture: its control points enclose it, since weights are positive. The same text for GLSL
// and for C++.
#ifndef KNOTSPAN_HULL_ON_SCREEN_GLSL
#define KNOTSPAN_HULL_ON_SCREEN_GLSL

#include "../shared/pixel_map.glsl"
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// Of the numbers that a vertex' clip coordinates are summed from: what evaluation and transformation in float may be off.
#define HULL_ROUNDING 4e-6f
// The rasterizer rounds vertices to 1/256 pixel, and some draw what is that near to a pixel's middle.
#define HULL_PIXELS 0.015625f

// With another point, homogeneous; `off`: what rounding may have changed of its x, y, z and w in the picture.
KNOTSPAN_INLINE HullOnScreen including(HullOnScreen hull, KNOTSPAN_FLOAT_MAP map, vec4 point, vec4 off)
{
    float x = dot(map.x, point);
    float y = dot(map.y, point);
    float z = dot(map.z, point);
    float w = dot(map.w, point);
    float overX = map.middle.x * w + off.x + map.middle.x * off.w;
    float overY = map.middle.y * w + off.y + map.middle.y * off.w;
    // Beyond the near plane is z > w, and beyond the far one z < 0.
    hull.beyond &= (x < -overX ? 1u : 0u) | (x > overX ? 2u : 0u) | (y < -overY ? 4u : 0u) | (y > overY ? 8u : 0u) |
                   (z > w + off.z + off.w ? 16u : 0u) | (z < -off.z ? 32u : 0u);
    hull.front = hull.front && z <= w - off.z - off.w && w > 2.0f * off.w;
    if (hull.front) {
        vec2 at = vec2(x, y) / w;
        vec2 around = (vec2(off.x, off.y) + abs(at) * off.w) / (w - off.w) + vec2(HULL_PIXELS);
        hull.low = min(hull.low, at - around);
        hull.high = max(hull.high, at + around);
        hull.nearest = max(hull.nearest, (z + off.z) / (w - off.w));
    }
    return hull;
}

// The Bezier points enclose a KSQuad closely; the surface's control points reach far beyond it.
KNOTSPAN_SCENE_TEMPLATE
HullOnScreen hullOnScreen(KNOTSPAN_SOURCE uint ksquad)
{
    uint surface = KNOTSPAN_KSQUAD(ksquad).surface;
    uint first = KNOTSPAN_KSQUAD(ksquad).firstPoint;
    uint stride = KNOTSPAN_SURFACE(surface).stride;
    uint p = KNOTSPAN_SURFACE(surface).degreeU;
    uint q = KNOTSPAN_SURFACE(surface).degreeV;
    uint tableU = KNOTSPAN_KSQUAD(ksquad).spanU - (p + 1u) * (p + 1u);
    uint tableV = KNOTSPAN_KSQUAD(ksquad).spanV - (q + 1u) * (q + 1u);
    KNOTSPAN_FLOAT_MAP map = KNOTSPAN_PIXEL_MAP(surface);
    // A Bezier point is summed from shares of the control points, which are not negative and have the sum 1.
    vec4 size = vec4(0.0f);
    for (uint i = 0u; i <= p; ++i)
        for (uint j = 0u; j <= q; ++j)
            size = max(size, abs(vec4(KNOTSPAN_POINT(first + i * stride + j))));
    vec4 off = HULL_ROUNDING * vec4(dot(abs(map.x), size), dot(abs(map.y), size), dot(abs(map.z), size),
                                    dot(abs(map.w), size));
    HullOnScreen hull;
    hull.beyond = 63u;
    hull.front = true;
    hull.low = vec2(3e38f);
    hull.high = vec2(-3e38f);
    hull.nearest = 0.0f;
    for (uint l = 0u; l <= q; ++l) {
        vec4 row[KNOTSPAN_MAX_ORDER];  // point l along v of each row of control points
        for (uint i = 0u; i <= p; ++i) {
            vec4 sum = vec4(0.0f);
            for (uint j = 0u; j <= q; ++j)
                sum += float(KNOTSPAN_TABLE(tableV + l * (q + 1u) + j)) *
                       vec4(KNOTSPAN_POINT(first + i * stride + j));
            row[i] = sum;
        }
        for (uint k = 0u; k <= p; ++k) {
            vec4 point = vec4(0.0f);
            for (uint i = 0u; i <= p; ++i)
                point += float(KNOTSPAN_TABLE(tableU + k * (p + 1u) + i)) * row[i];
            hull = including(hull, map, point, off);
        }
    }
    return hull;
}

KNOTSPAN_SCENE_TEMPLATE
SeenKsQuad seenKsQuad(KNOTSPAN_SOURCE uint ksquad)
{
    SeenKsQuad seen;
    seen.view = KNOTSPAN_SURFACE_VIEW(KNOTSPAN_KSQUAD(ksquad).surface);
    seen.side = KNOTSPAN_SHOWN_SIDE(KNOTSPAN_KSQUAD(ksquad).surface);
    return seen;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
