// Pixels of which trim loops leave nothing: they get no colour, no index and no depth. Stages that know of them are compiled
// with KNOTSPAN_TRIMMED, and drawn with where a surface is trimmed.
//
// Differences between pixels are to be taken before: a discarded pixel has none, and the software driver runs no loops for
// the pixels beside a triangle.
#ifdef KNOTSPAN_TRIMMED
layout(set = 0, binding = BINDING_TRIM_WORDS, scalar) readonly buffer TrimBuffer { uint trimWords[]; };

#include "../shared/trimming.glsl"
#include "pixel_aim.glsl"

// The place of the surface that this pixel shows, where loops cut its KSQuad. The triangle lies beside the surface, by as
// much as the tolerance: one step towards the pixel's centre, so that surfaces that meet along a loop leave no pixel between
// them, however each is cut into triangles.
PixelPlace trimmedPlace()
{
    const float kMostMissed = 4.0;  // pixels, beyond what anyone takes for a tolerance; and of a KSQuad:
    const float kMostChange = 0.5;
    // Parameters run the way that the tolerance is about (surface_io.glsl).
    PixelPlace place = pixelPlace(inInverseWeight > 0.0 ? inWeightedT / inInverseWeight : inT);
    if (trimWords[place.ksquad] <= TRIM_OUTSIDE)
        return place;
    uint surface = ksquads[place.ksquad].surface;
    SurfaceSample at = sampleKsQuad(ksquads[place.ksquad], place.t);
    mat3 turn = mat3(surfaceViews[surface].modelView);
    Aim aim = aimOf(toView(surface, at.position), turn * at.du, turn * at.dv);
    vec2 change = aim.along[0] * aim.missed.x + aim.along[1] * aim.missed.y;
    bool isNear = length(aim.missed) < kMostMissed && max(abs(change.x), abs(change.y)) < kMostChange;
    return isNear ? stepped(surface, place, change) : place;
}

void discardTrimmed()
{
    PixelPlace place = trimmedPlace();
    if (!trimContains(place.ksquad, place.t))
        discard;
}
#else
void discardTrimmed() {}
#endif
