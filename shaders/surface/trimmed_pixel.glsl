// Pixels of which trim loops leave nothing at their centre: they get no colour, no index and no depth. Stages that know of
// them are compiled with KNOTSPAN_TRIMMED, and drawn with where a surface is trimmed. How much of a pixel is left is found
// later, of those that show (overlay/trim_edge.glsl).
//
// Differences between pixels are to be taken before: a discarded pixel has none, and the software driver runs no loops for
// the pixels beside a triangle.
#ifdef KNOTSPAN_TRIMMED
#include "../shared/trimming_words.glsl"
#include "../shared/pixel_aim.glsl"

// A flat surface's triangles are the surface itself.
bool isFlat(uint surface) { return max(surfaces[surface].degreeU, surfaces[surface].degreeV) == 1u; }

// Parameters run the way that the tolerance is about (surface_io.glsl).
vec2 aimedT() { return inInverseWeight > 0.0 ? inWeightedT / inInverseWeight : inT; }

void discardTrimmed()
{
    PixelPlace place = pixelPlace(aimedT());
    uint word = trimWords[place.ksquad];
    uint side = word < TRIM_RECORDS ? word : trimSquareSide(word, place.t);
    if (side == TRIM_OUTSIDE)
        discard;
    if (side != TRIM_NEAR)
        return;
    // From the triangle to the surface: surfaces that meet along a loop leave no pixel between them, however each is cut
    // into triangles.
    uint surface = ksquads[place.ksquad].surface;
    mat2 along = mat2(0.0);
    if (!isFlat(surface))
        place = aimedPlace(surface, place, gl_FragCoord.xy, along);
    if (!trimContains(place.ksquad, clamp(place.t, 0.0, 1.0)))
        discard;
}
#else
void discardTrimmed() {}
#endif
