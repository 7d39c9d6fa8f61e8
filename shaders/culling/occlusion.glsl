// Culling by occlusion is not for a KSQuad alone: it looks at what has been drawn. cull.comp lets what the last frame saw be
// drawn first, occlusion.comp decides on the rest.
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
bool culledByOcclusion(KNOTSPAN_SOURCE KNOTSPAN_UNUSED uint ksquad, KNOTSPAN_UNUSED SeenKsQuad seen)
{
    return false;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
