// Light quad culling (GRAPP; MESH: KSQuad-level culling): the plane of the KSQuad's four corners against the view
// direction. It drops KSQuads that show where they bend.
#include "facing.glsl"

bool culledByLqc(KsQuadRecord ksquad, SurfaceView view)
{
    vec3 corners[4];
    for (int k = 0; k < 4; ++k)
        corners[k] = positionOf(ksquad, vec2(k & 1, k >> 1));
    return cornersFaceAway(corners, view.eye);
}
