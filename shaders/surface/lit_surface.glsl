// The colour of a surface's pixel: where all paths end. exact_surface.glsl and
// error_surface.glsl stand in its place where a picture judges surfaces.
#include "../shared/scene.glsl"
#include "surface_io.glsl"

SURFACE_IN

#include "surface_colour.glsl"
#include "trimmed_pixel.glsl"

// A colour for each KSQuad that neighbours rarely share.
vec3 ksquadColour(uint index)
{
    uint h = index * 2654435769u;
    h = (h ^ h >> 15) * 2246822519u;
    float hue = float(h & 0xffffu) / 65536.0;
    vec3 rainbow = clamp(abs(fract(hue + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    return mix(vec3(0.55), rainbow, 0.45) * (0.6 + 0.4 * float(h >> 24) / 255.0);
}

void main()
{
    vec2 perPixel = fwidth(inT);
    discardTrimmed();
    PixelPlace place = pixelPlace(inT);
    uint surface = ksquads[inKsquad].surface;
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    vec3 towardsEye = orthographic ? vec3(0, 0, 1) : -normalize(inPosition);
    vec3 n = normalize(inNormal) * surfaceViews[surface].facing;
    bool front = dot(n, towardsEye) >= 0.0;
    vec3 facing = front ? n : -n;

    vec3 albedo = frame.shading == SHADING_KSQUADS ? ksquadColour(place.ksquad) : surfaces[surface].colour;
    vec3 colour = lit(front ? albedo : albedo * kInside, facing, towardsEye);
    colour = mix(colour, vec3(1.0, 0.45, 0.08), 0.22 * surfaceViews[surface].highlight);
    if (frame.isoCurves > 1u)
        colour = mix(colour, vec3(0.015), 0.4 * isoCurve(place.t, perPixel));
    if ((frame.flags & FRAME_KNOT_LINES) != 0u)
        colour = mix(colour, vec3(0.015), 0.8 * knotLine(place.t, perPixel));
    outColour = vec4(encodedSrgb(colour), 1.0);
    outPicked = pickedOf(place);
}
