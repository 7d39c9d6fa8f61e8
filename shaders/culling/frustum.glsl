// Frustum culling: the whole KSQuad is beyond one of the planes that bound the picture.
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
bool culledByFrustum(KNOTSPAN_SOURCE KNOTSPAN_UNUSED uint ksquad, SeenKsQuad seen)
{
    return seen.hull.beyond != 0u;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
