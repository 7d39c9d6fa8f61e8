// Light quad culling (GRAPP; MESH: KSQuad-level culling): the plane of the KSQuad's four corners against the view
// direction. It drops KSQuads that show where they bend.
#include "facing.glsl"
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
bool culledByLqc(KNOTSPAN_SOURCE uint ksquad, SeenKsQuad seen)
{
    vec3 corners[4];
    for (uint k = 0u; k < 4u; ++k)
        corners[k] = KNOTSPAN_POSITION(ksquad, vec2(float(k & 1u), float(k >> 1u)));
    return cornersFaceAway(corners[0], corners[1], corners[2], corners[3], seen.view.eye);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
