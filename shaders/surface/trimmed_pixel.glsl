// Pixels of which trim loops leave nothing: they get no colour, no index and no depth. Stages that know of them are compiled
// with KNOTSPAN_TRIMMED, and drawn with where a surface is trimmed.
//
// Differences between pixels are to be taken before: a discarded pixel has none, and the software driver runs no loops for
// the pixels beside a triangle.
#ifdef KNOTSPAN_TRIMMED
layout(set = 0, binding = BINDING_TRIM_WORDS, scalar) readonly buffer TrimBuffer { uint trimWords[]; };

#include "../shared/trimming.glsl"

void discardTrimmed()
{
    // Parameters run the way that the tolerance is about (surface_io.glsl), so that edges are off by no more than that.
    PixelPlace place = pixelPlace(inInverseWeight > 0.0 ? inWeightedT / inInverseWeight : inT);
    if (!trimContains(place.ksquad, place.t))
        discard;
}
#else
void discardTrimmed() {}
#endif
