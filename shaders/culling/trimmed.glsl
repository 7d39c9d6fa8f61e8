// What trim loops leave nothing of. Whether it is dropped or not: the fragment stage draws none of it.
#include "../shared/trimming.glsl"
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
bool culledByTrimmed(KNOTSPAN_SOURCE uint ksquad, KNOTSPAN_UNUSED SeenKsQuad seen)
{
    return KNOTSPAN_TRIM_VERDICT(ksquad) == TRIM_OUTSIDE;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
