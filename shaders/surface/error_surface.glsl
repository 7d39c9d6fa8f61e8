// How far a surface's pixel is off: stands in the place of lit_surface.glsl where the frame shows errors. A stage of its
// own, so that other pictures neither evaluate nor compile it.
//
// The triangle's point at this pixel has parameters; the exact surface's point there falls elsewhere on the screen, and the
// distance from the pixel's centre is the error. Parameters run over a triangle in two ways (surface_io.glsl), and either
// way that is a distance to the surface. The bound is about the second, by homogeneous coordinates; but where weights
// differ much float loses it in the rasterizer. So the first counts, and the second where the first is too far off.
#include "../shared/counters.glsl"
#include "surface_io.glsl"

SURFACE_IN

#include "surface_colour.glsl"
#include "trimmed_pixel.glsl"

// What is hidden already is not measured. What something nearer hides later is: the order of drawing decides whether
// it takes part in the mean, but every triangle keeps the tolerance, so the largest error is one of a drawn triangle.
// Where pixels are trimmed away, what is hidden is measured, too: depth is only known behind the stage then.
#ifndef KNOTSPAN_TRIMMED
layout(early_fragment_tests) in;
#endif

const float kFarthest = 65536.0;  // also of points behind the eye

vec2 inPicture(vec4 clip) { return (0.5 * clip.xy / clip.w + 0.5) * frame.pixels; }

// How far from `pixel` the exact surface's point at t falls, and where.
float distanceAt(uint surface, vec2 t, vec2 pixel, out vec2 shown)
{
    PixelPlace at = pixelPlace(t);
    vec4 clip = toClip(toView(surface, positionOf(ksquads[at.ksquad], clamp(at.t, 0.0, 1.0))));
    shown = inPicture(clip);
    float pixels = distance(shown, pixel);
    return clip.w > 0.0 && pixels < kFarthest ? pixels : kFarthest;  // what is no number is less than nothing
}

// The rasterizer rounds vertices to parts of a pixel. So of a triangle that is seen edge-on it may take a pixel for one of
// the triangle that lies just beside it, and the parameters there are far outside the triangle. Where a pixel seems too
// far off, places are looked at that rounding cannot tell from its centre, on the line along which parameters change most
// and as far as they stay on the surface: in rounds, each around the best of the one before.
const float kRounding = 1.0 / 128.0;  // pixels
const int kPlaces = 16;
const int kRounds = 4;

// Of a triangle so thin that float loses its area all that is interpolated is noise, which shows where interpolated
// positions do not fall on their pixels; here and beside here, as one may hit its place by chance. Which point of the
// triangle such a pixel shows nobody can tell. Where it seems too far off it is counted as lost, and its error is how
// near the surface comes to it, followed from the best parameters so far.
const float kLost = 1.0 / 32.0;  // pixels

float interpolationNoise()
{
    vec2 missed = inPicture(toClip(inPosition)) - gl_FragCoord.xy;
    return length(missed) + length(dFdx(missed)) + length(dFdy(missed));
}

// The change of t that takes a point by `wanted` on the screen, where t takes it by `slopes`.
vec2 dampedStep(mat2 slopes, vec2 wanted, float damping)
{
    mat2 square = transpose(slopes) * slopes;
    square[0][0] *= 1.0 + damping;
    square[1][1] *= 1.0 + damping;
    return determinant(square) > 0.0 ? inverse(square) * (wanted * slopes) : vec2(0.0);
}

// By damped Newton steps, with differences for derivatives.
float distanceNear(uint surface, vec2 t, vec2 most)
{
    const int kSteps = 32;
    float least = kFarthest;
    float damping = 1e-3;
    vec2 found = clamp(t, vec2(0.0), most);
    vec2 tried = found;
    vec2 difference = mix(vec2(1e-3), vec2(-1e-3), greaterThan(found, 0.5 * most));
    vec2 shownThere = vec2(0.0);
    mat2 slopes = mat2(0.0);
    for (int k = 0; k < 3 * kSteps && least > frame.tolerancePx; ++k) {
        int turn = k % 3;
        vec2 shown;
        vec2 beside = found + difference * vec2(turn == 1, turn == 2);
        float pixels = distanceAt(surface, turn == 0 ? tried : beside, gl_FragCoord.xy, shown);
        if (turn > 0) {
            slopes[turn - 1] = (shown - shownThere) / difference[turn - 1];
        } else if (pixels < least) {
            least = pixels;
            found = tried;
            shownThere = shown;
            damping *= 0.1;
        } else {
            damping *= 10.0;
        }
        if (turn == 2)
            tried = clamp(found + dampedStep(slopes, gl_FragCoord.xy - shownThere, damping), vec2(0.0), most);
    }
    return least;
}

struct PixelError {
    float pixels;
    bool lost;
};

PixelError errorHere(uint surface)
{
    bool spans = (frame.flags & FRAME_SPANS) != 0u;
    vec2 most = spans ? vec2(surfaces[surface].spansU, surfaces[surface].spansV) : vec2(1.0);
    // Homogeneous, so that they and their changes are linear on the screen: from pixel to pixel what a thin triangle's
    // perspective makes of them is not.
    vec3 places[2] = vec3[2](gl_FragCoord.w * vec3(inT, 1.0), gl_FragCoord.w * vec3(inWeightedT, inInverseWeight));
    mat2x3 changes[2] = mat2x3[2](mat2x3(dFdx(places[0]), dFdy(places[0])), mat2x3(dFdx(places[1]), dFdy(places[1])));
    bool noisy = !(interpolationNoise() < kLost);
    discardTrimmed();
    float least = kFarthest;
    vec2 found = vec2(0.0);
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
            vec2 shift = k == 0 ? vec2(0.0) : place * aside;
            vec3 beside = centre + changing * shift;
            vec2 shown;
            float pixels = distanceAt(surface, beside.xy / beside.z, gl_FragCoord.xy + shift, shown);
            if (pixels < leastHere) {
                leastHere = pixels;
                best = place;
            }
            if (pixels < least) {
                least = pixels;
                found = beside.xy / beside.z;
            }
            if (k % kPlaces == 0 && k > 0) {
                float step = (high - low) / float(kPlaces);
                low = best - step;
                high = best + step;
            }
        }
    }
    if (!noisy || least <= frame.tolerancePx)
        return PixelError(least, false);
    return PixelError(min(least, distanceNear(surface, found, most)), true);
}

void count(PixelError error)
{
    atomicMax(counters.errorMax, floatBitsToUint(error.pixels));
    atomicAdd(counters.errorPixels, 1u);
    if (error.lost)
        atomicAdd(counters.errorLost, 1u);
    KNOTSPAN_COUNT(counters.errorSum, uint(error.pixels * 4096.0 + 0.5))
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
    vec2 perPixel = fwidth(inT);
    uint surface = ksquads[inKsquad].surface;
    PixelError error = errorHere(surface);
    if ((frame.flags & FRAME_MEASURE_ERROR) != 0u)
        count(error);
    vec3 colour = errorColour(error.pixels / frame.tolerancePx);
    if (error.pixels > frame.tolerancePx + KNOTSPAN_ERROR_NOISE_PX)
        colour = vec3(0.92, 0.0, 0.5);
    if (frame.isoCurves > 1u)
        colour = mix(colour, vec3(0.06), 0.4 * isoCurve(pixelPlace(inT).t, perPixel));
    if ((frame.flags & FRAME_KNOT_LINES) != 0u)
        colour = mix(colour, vec3(0.06), 0.8 * knotLine(pixelPlace(inT).t, perPixel));
    outColour = vec4(colour, 1.0);
    outPicked = pickedOf(pixelPlace(inT));
}
