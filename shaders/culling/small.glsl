// What no pixel's middle lies in: a row or a column of middles passes beside all of the KSQuad, so that no triangle of it
// can own a pixel. As edges are watertight, that leaves no hole.
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
bool culledBySmall(KNOTSPAN_SOURCE uint ksquad, SeenKsQuad seen)
{
    if (!seen.hull.front)
        return false;
    // Middles are half a pixel beside whole numbers, counted from the picture's border.
    vec2 shift = KNOTSPAN_PIXEL_MAP(KNOTSPAN_KSQUAD(ksquad).surface).middle - vec2(0.5f);
    vec2 low = ceil(seen.hull.low + shift);
    vec2 high = floor(seen.hull.high + shift);
    return low.x > high.x || low.y > high.y;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
