#include "lighting.glsl"

// What the fragment stages write, and what their colours have in common.
layout(location = 0) out vec4 outColour;   // sRGB, encoded here
layout(location = 1) out uvec2 outPicked;  // pickedOf()

#include "../shared/pixel_place.glsl"

// Where a place on a triangle is: a triangle of a whole surface lies on several KSQuads.
PixelPlace pixelPlace(vec2 t)
{
    if ((frame.flags & FRAME_SPANS) == 0u)
        return PixelPlace(inKsquad, t);
    uint surface = ksquads[inKsquad].surface;
    vec2 spans = vec2(surfaces[surface].spansU, surfaces[surface].spansV);
    vec2 before = clamp(floor(t), vec2(0.0), spans - 1.0);
    return PixelPlace(surfaces[surface].firstKsquad + uint(before.x) * surfaces[surface].spansV + uint(before.y),
                      t - before);
}

// How much of a line of about 1.5 pixels along the KSQuad's border covers this pixel. `perPixel` is how t changes from
// pixel to pixel, taken before pixels are discarded.
float knotLine(vec2 t, vec2 perPixel)
{
    vec2 pixels = min(t, 1.0 - t) / max(frame.handPx * perPixel, vec2(1e-9));
    return 1.0 - smoothstep(0.4, 1.3, min(pixels.x, pixels.y));
}

// The same of thinner lines that cut the KSQuad into frame.isoCurves parts each way; of lines too close to be told
// apart there are none.
float isoCurve(vec2 t, vec2 changes)
{
    float parts = float(frame.isoCurves);
    vec2 perPixel = max(frame.handPx * changes, vec2(1e-9));
    vec2 pixels = abs(t - clamp(round(t * parts), 1.0, parts - 1.0) / parts) / perPixel;
    vec2 covered = (1.0 - smoothstep(0.1, 0.9, pixels)) * smoothstep(2.0, 5.0, 1.0 / (parts * perPixel));
    return max(covered.x, covered.y);
}
