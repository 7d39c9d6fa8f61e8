// The colour of a surface's pixel where it is judged: by the exact surface there. Stands in the place of lit_surface.glsl; a
// stage of its own, so that other pictures neither evaluate nor compile it.
#include "../shared/colour_ramp.glsl"
#include "../shared/scene.glsl"
#include "surface_io.glsl"

SURFACE_IN

#include "surface_colour.glsl"
#include "trimmed_pixel.glsl"

#include "exact_point.glsl"
#include "looks.glsl"

#ifndef KNOTSPAN_TRIMMED
layout(early_fragment_tests) in;
#endif

// Encoded sRGB.
vec3 lookOf(uint surface, ExactPoint at)
{
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    vec3 towardsEye = orthographic ? vec3(0, 0, 1) : -normalize(at.position);
    bool front = dot(at.normal, towardsEye) >= 0.0;
    vec3 inside = front ? vec3(1.0) : kInside;
    switch (frame.shading) {
    case SHADING_ZEBRA:
        return zebra(at, towardsEye, inside);
    case SHADING_REFLECTION:
        return reflectionLines(at, towardsEye, inside);
    case SHADING_ISOPHOTES:
        return isophotes(at, inside);
    case SHADING_MATCAP:
        return matcap(front ? at.normal : -at.normal, towardsEye) * inside;
    case SHADING_CURVATURE:
        return numberColour(curvatureFigure(at));
    case SHADING_DRAFT:
        return numberColour(draftDegrees(at.normal));
    case SHADING_CHECKER:
        return checker(surface, at, inside);
    case SHADING_DEVIATION:
        return numberColour(deviationAt(at.place));
    default:
        return 0.5 + 0.5 * at.normal;
    }
}

void main()
{
    vec2 perPixel = fwidth(inT);
    discardTrimmed();
    uint surface = ksquads[inKsquad].surface;
    ExactPoint at = exactPoint(surface, inT);
    vec3 colour = lookOf(surface, at);
    PixelPlace place = pixelPlace(inT);
    if (frame.isoCurves > 1u)
        colour = mix(colour, vec3(0.08), 0.4 * isoCurve(place.t, perPixel));
    if ((frame.flags & FRAME_KNOT_LINES) != 0u)
        colour = mix(colour, vec3(0.08), 0.8 * knotLine(place.t, perPixel));
    outColour = vec4(colour, 1.0);
    outPicked = pickedOf(place);
}
