// Surface-level culling (MESH): the plane of the whole surface's four corners against the view direction.
#include "facing.glsl"
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
bool culledBySurface(KNOTSPAN_SOURCE uint ksquad, SeenKsQuad seen)
{
    uint surface = KNOTSPAN_KSQUAD(ksquad).surface;
    return cornersFaceAway(KNOTSPAN_SURFACE(surface).corners[0], KNOTSPAN_SURFACE(surface).corners[1],
                           KNOTSPAN_SURFACE(surface).corners[2], KNOTSPAN_SURFACE(surface).corners[3], seen.view.eye);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
