// How far a surface's pixel is off: stands in the place of surface.frag where the frame shows errors. A stage of its
// own, so that other pictures neither evaluate nor compile it.
//
// The triangle's point at this pixel has parameters; the exact surface's point there falls elsewhere on the screen, and the
// distance from the pixel's centre is the error. Parameters run over a triangle in two ways (surface_io.glsl), and either
// way that is a distance to the surface. The bound is about the second, by homogeneous coordinates; but where weights
// differ much float loses it in the rasterizer. So the first counts, and the second where the first is too far off.
#version 460
#extension GL_GOOGLE_include_directive : require

#include "../shared/counters.glsl"
#include "surface_io.glsl"

SURFACE_IN

#include "surface_colour.glsl"

// What is hidden already is not measured. What something nearer hides later is: the order of drawing decides whether
// it takes part in the mean, but every triangle keeps the tolerance, so the largest error is one of a drawn triangle.
layout(early_fragment_tests) in;

const float kFarthest = 65536.0;  // also of points behind the eye

vec2 inPicture(vec4 clip) { return (0.5 * clip.xy / clip.w + 0.5) * frame.pixels; }

// The rasterizer rounds vertices to parts of a pixel. So of a triangle that is seen edge-on it may take a pixel for one of
// the triangle that lies just beside it, and the parameters there are far outside the triangle. Where a pixel seems too
// far off, places are looked at that rounding cannot tell from its centre, on the line along which parameters change most
// and as far as they stay on the surface: in rounds, each around the best of the one before.
const float kRounding = 1.0 / 128.0;  // pixels
const int kPlaces = 16;
const int kRounds = 4;

// Of a triangle so thin that float loses its area what is interpolated means nothing, which shows where the interpolated
// position does not fall on the pixel. Such a pixel is not measured; that is only asked where one seems too far off.
const float kLost = 1.0 / 32.0;

float errorInPixels(uint surface)
{
    bool spans = (frame.flags & FRAME_SPANS) != 0u;
    vec2 most = spans ? vec2(surfaces[surface].spansU, surfaces[surface].spansV) : vec2(1.0);
    // Homogeneous, so that they and their changes are linear on the screen: from pixel to pixel what a thin triangle's
    // perspective makes of them is not.
    vec3 places[2] = vec3[2](gl_FragCoord.w * vec3(inT, 1.0), gl_FragCoord.w * vec3(inWeightedT, inInverseWeight));
    mat2x3 changes[2] = mat2x3[2](mat2x3(dFdx(places[0]), dFdy(places[0])), mat2x3(dFdx(places[1]), dFdy(places[1])));
    float least = kFarthest;
    for (int way = 0; way < 2 && least > frame.tolerancePx; ++way) {
        vec3 centre = places[way];
        mat2x3 changing = changes[way];
        vec2 t = centre.xy / centre.z;
        mat2 change = mat2(changing[0].xy - t * changing[0].z, changing[1].xy - t * changing[1].z) / centre.z;
        mat2 square = transpose(change) * change;
        float angle = 0.5 * atan(2.0 * square[0][1], square[0][0] - square[1][1]);
        vec2 aside = abs(angle) < 4.0 ? vec2(cos(angle), sin(angle)) : vec2(1.0, 0.0);
        vec2 along = change * aside;
        along = mix(vec2(1e-12), along, greaterThan(abs(along), vec2(1e-12)));
        vec2 ends[2] = vec2[2](min(-t / along, (most - t) / along), max(-t / along, (most - t) / along));
        float low = max(max(ends[0].x, ends[0].y), -kRounding);
        float high = min(min(ends[1].x, ends[1].y), kRounding);
        float best = 0.0;
        float leastHere = kFarthest;
        for (int k = 0; k <= kRounds * kPlaces && leastHere > frame.tolerancePx; ++k) {
            float place = k == 0 ? 0.0 : mix(low, high, (float((k - 1) % kPlaces) + 0.5) / float(kPlaces));
            vec3 beside = centre + changing * (k == 0 ? vec2(0.0) : place * aside);
            PixelPlace at = pixelPlace(beside.xy / beside.z);
            vec4 clip = toClip(toView(surface, positionOf(ksquads[at.ksquad], clamp(at.t, 0.0, 1.0))));
            float error = distance(inPicture(clip), gl_FragCoord.xy + place * aside);
            if (clip.w > 0.0 && error < leastHere) {  // what is no number is less than nothing
                leastHere = error;
                best = place;
            }
            if (k % kPlaces == 0 && k > 0) {
                float step = (high - low) / float(kPlaces);
                low = best - step;
                high = best + step;
            }
        }
        least = min(least, leastHere);
    }
    bool lost = least > frame.tolerancePx &&
                !(distance(inPicture(toClip(inPosition)), gl_FragCoord.xy) < kLost);
    return lost ? -1.0 : least;
}

void count(float error)
{
    atomicMax(counters.errorMax, floatBitsToUint(error));
    atomicAdd(counters.errorPixels, 1u);
    KNOTSPAN_COUNT(counters.errorSum, uint(error * 4096.0 + 0.5))
}

// Darker is truer: from dark blue to pale yellow at the tolerance, which people of any colour vision tell apart;
// beyond it the colour jumps.
vec3 errorColour(float ofTolerance)
{
    const vec3 stops[4] = vec3[](vec3(0.03, 0.12, 0.36), vec3(0.27, 0.38, 0.53), vec3(0.68, 0.66, 0.52),
                                 vec3(1.0, 0.96, 0.72));
    float at = 3.0 * clamp(ofTolerance, 0.0, 1.0);
    uint stop = min(uint(at), 2u);
    return mix(stops[stop], stops[stop + 1u], at - float(stop));
}

void main()
{
    uint surface = ksquads[inKsquad].surface;
    float error = errorInPixels(surface);
    if ((frame.flags & FRAME_MEASURE_ERROR) != 0u && error >= 0.0)
        count(error);
    vec3 colour = errorColour(error / frame.tolerancePx);
    if (error > frame.tolerancePx + KNOTSPAN_ERROR_NOISE_PX)
        colour = vec3(0.92, 0.0, 0.5);
    if ((frame.flags & FRAME_KNOT_LINES) != 0u)
        colour = mix(colour, vec3(0.06), 0.8 * knotLine(pixelPlace(inT).t));
    outColour = vec4(colour, 1.0);
    outSurface = surface + 1u;
}
