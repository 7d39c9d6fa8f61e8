// Strong quad culling: the whole KSQuad faces away, provably, on a surface of which one side is shown. By a box around the
// coefficients that say so (sqc), or by each of them (sqc-full).
#include "../shared/facing_forms.glsl"
#include "seen_ksquad.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_SCENE_TEMPLATE
FacingEye facingEyeOf(KNOTSPAN_SOURCE uint ksquad, SeenKsQuad seen)
{
    uint surface = KNOTSPAN_KSQUAD(ksquad).surface;
    uint middle = KNOTSPAN_KSQUAD(ksquad).firstPoint +
                  KNOTSPAN_SURFACE(surface).degreeU / 2u * KNOTSPAN_SURFACE(surface).stride +
                  KNOTSPAN_SURFACE(surface).degreeV / 2u;
    vec4 point = vec4(KNOTSPAN_POINT(middle));
    FacingEye eye = facingEye(KNOTSPAN_FACING_BOX(ksquad), vec3(point) / point.w, seen.view.eye);
    // Where the other side is shown, it is the one that has to face away.
    eye.along *= seen.side;
    eye.across *= seen.side;
    return eye;
}

KNOTSPAN_SCENE_TEMPLATE
bool culledBySqc(KNOTSPAN_SOURCE uint ksquad, SeenKsQuad seen)
{
    if (seen.side == 0.0f)
        return false;
    FacingEye eye = facingEyeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, seen);
    return boxFacesAway(KNOTSPAN_FACING_BOX(ksquad), eye);
}

KNOTSPAN_SCENE_TEMPLATE
bool culledBySqcFull(KNOTSPAN_SOURCE uint ksquad, SeenKsQuad seen)
{
    if (seen.side == 0.0f)
        return false;
    FacingEye eye = facingEyeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, seen);
    if (boxFacesAway(KNOTSPAN_FACING_BOX(ksquad), eye))
        return true;
    uint surface = KNOTSPAN_KSQUAD(ksquad).surface;
    uint words = facingWordCount(KNOTSPAN_SURFACE(surface).degreeU, KNOTSPAN_SURFACE(surface).degreeV);
    uint first =
        KNOTSPAN_SURFACE(surface).firstFacingWord + (ksquad - KNOTSPAN_SURFACE(surface).firstKsquad) * words;
    return raysFaceAway KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE KNOTSPAN_FACING_BOX(ksquad), eye, first, words);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
