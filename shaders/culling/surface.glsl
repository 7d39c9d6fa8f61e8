// Surface-level culling (MESH): the plane of the whole surface's four corners against the view direction.
#include "facing.glsl"

bool culledBySurface(KsQuadRecord ksquad, SurfaceView view)
{
    return cornersFaceAway(surfaces[ksquad.surface].corners, view.eye);
}
