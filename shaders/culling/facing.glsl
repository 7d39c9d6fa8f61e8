// Whether four corners, as a flat quad, face away from the eye.
// All in the surface's own coordinates, so that a mirroring transform changes nothing.
#ifndef KNOTSPAN_FACING_GLSL
#define KNOTSPAN_FACING_GLSL

#include "../shared/scene.glsl"

// Corners at (u,v) = (0,0), (1,0), (0,1), (1,1). The normal is the diagonals' product, which points as S_u x S_v does.
bool cornersFaceAway(vec3 corners[4], vec4 eye)
{
    vec3 normal = cross(corners[3] - corners[0], corners[2] - corners[1]);
    vec3 centre = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    return dot(normal, eye.xyz - eye.w * centre) < 0.0;
}

#endif
