// Whether four corners, as a flat quad, face away from the eye: the same text for GLSL and for C++.
// All in the surface's own coordinates, so that a mirroring transform changes nothing.
#ifndef KNOTSPAN_FACING_GLSL
#define KNOTSPAN_FACING_GLSL

#include "../shared/language.h"
#include "../shared/layouts.h"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// Corners at (u,v) = (0,0), (1,0), (0,1), (1,1). The normal is the diagonals' product, which points as S_u x S_v does.
KNOTSPAN_INLINE bool cornersFaceAway(vec3 c00, vec3 c10, vec3 c01, vec3 c11, vec4 eye)
{
    vec3 normal = cross(c11 - c00, c01 - c10);
    vec3 centre = 0.25f * (c00 + c10 + c01 + c11);
    return dot(normal, vec3(eye) - eye.w * centre) < 0.0f;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
