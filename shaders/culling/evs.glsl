// Exact visible set (RPNS): of what is drawn, KSDice that nobody can see are dropped before they are rasterized. A function
// of the stages that put triangles out; for a KSQuad as a whole it says nothing.
#ifndef KNOTSPAN_EVS_GLSL
#define KNOTSPAN_EVS_GLSL

#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
bool culledByEvs(KNOTSPAN_SOURCE KNOTSPAN_UNUSED uint ksquad, KNOTSPAN_UNUSED SeenKsQuad seen)
{
    return false;
}

// The clip planes that a vertex is beyond, a bit each, and one for a cull distance that says it faces away.
KNOTSPAN_INLINE uint vertexBeyond(vec4 clip, float shown)
{
    return (clip.x < -clip.w ? 1u : 0u) | (clip.x > clip.w ? 2u : 0u) | (clip.y < -clip.w ? 4u : 0u) |
           (clip.y > clip.w ? 8u : 0u) | (clip.z > clip.w ? 16u : 0u) | (clip.z < 0.0f ? 32u : 0u) |
           (shown < 0.0f ? 64u : 0u);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
