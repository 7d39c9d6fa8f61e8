// What an exact point looks like under each of the shadings by which a surface is judged. Colours are sRGB, encoded:
// numbers keep the colours of the legend, without light.

// A square wave of period 1, one half 1 and one half 0, seen through a pixel `width` wide.
float evenStripes(float x, float width)
{
    vec2 ends = x + vec2(-0.5, 0.5) * width;
    vec2 white = 0.5 * floor(ends) + min(fract(ends), 0.5);
    return clamp((white.y - white.x) / width, 0.0, 1.0);
}

// The same of thin lines around whole numbers.
float evenLines(float x, float width)
{
    const float kThickness = 0.12;
    vec2 ends = x + 0.5 * kThickness + vec2(-0.5, 0.5) * width;
    vec2 inked = kThickness * floor(ends) + min(fract(ends), kThickness);
    return clamp((inked.y - inked.x) / width, 0.0, 1.0);
}

// A number of stripes and how much of one a pixel sees.
struct Stripes {
    float at;
    float width;
};

// By the angle between a unit vector and the stripes' axis; `along` is how that vector changes from pixel to pixel. At both ends
// of the axis and half-way, where angles turn back, is the middle of a stripe.
Stripes stripesAt(vec3 direction, vec3 along[2])
{
    float cosine = dot(direction, frame.lookAxis);
    float sine = length(cross(direction, frame.lookAxis));
    vec2 change = vec2(dot(along[0], frame.lookAxis), dot(along[1], frame.lookAxis)) / max(sine, 1e-4);
    float stripes = frame.lookCount / 3.14159265;
    return Stripes(atan(sine, cosine) * stripes + 0.25, clamp(length(change) * stripes, 1e-4, 1e4));
}

// What the eye sees in the surface as in a mirror.
Stripes mirroredStripes(ExactPoint at, vec3 towardsEye)
{
    bool orthographic = (frame.flags & FRAME_ORTHOGRAPHIC) != 0u;
    vec3 along[2];
    for (int k = 0; k < 2; ++k) {
        vec3 step = at.positionAlong[k];
        vec3 turning = orthographic ? vec3(0.0) : (towardsEye * dot(towardsEye, step) - step) / length(at.position);
        along[k] = 2.0 * (dot(turning, at.normal) + dot(towardsEye, at.normalAlong[k])) * at.normal +
                   2.0 * dot(towardsEye, at.normal) * at.normalAlong[k] - turning;
    }
    return stripesAt(reflect(-towardsEye, at.normal), along);
}

// Bright bands around the eye, as wide as those between them.
vec3 zebra(ExactPoint at, vec3 towardsEye, vec3 inside)
{
    Stripes stripes = mirroredStripes(at, towardsEye);
    return mix(vec3(0.06), vec3(0.95), evenStripes(stripes.at, stripes.width)) * inside;
}

// Thin lines there: what light tubes above a car's body show.
vec3 reflectionLines(ExactPoint at, vec3 towardsEye, vec3 inside)
{
    Stripes stripes = mirroredStripes(at, towardsEye);
    return mix(vec3(0.82, 0.84, 0.86), vec3(0.05), evenLines(stripes.at, stripes.width)) * inside;
}

// Bands of one angle between the normal and the axis.
vec3 isophotes(ExactPoint at, vec3 inside)
{
    Stripes stripes = stripesAt(at.normal, at.normalAlong);
    return mix(vec3(0.16, 0.28, 0.42), vec3(0.93, 0.92, 0.86), evenStripes(stripes.at, stripes.width)) * inside;
}

// A ball of some material, lit in a studio, whose colour at a normal is the surface's.
vec3 matcap(vec3 facing, vec3 towardsEye)
{
    vec3 right = directionOf(cross(vec3(0.0, 1.0, 0.0), towardsEye));
    vec3 up = cross(towardsEye, right);
    vec3 ball = vec3(dot(facing, right), dot(facing, up), dot(facing, towardsEye));
    float key = max(dot(ball, normalize(vec3(-0.4, 0.6, 0.7))), 0.0);
    float rim = pow(1.0 - max(ball.z, 0.0), 3.0);
    if (frame.lookKind == LOOK_CHROME) {
        float height = ball.y + 0.12 * ball.x;
        vec3 sky = mix(vec3(0.80, 0.87, 0.95), vec3(0.22, 0.36, 0.58), clamp(height, 0.0, 1.0));
        vec3 ground = mix(vec3(0.10, 0.09, 0.09), vec3(0.55, 0.52, 0.48), clamp(-height, 0.0, 1.0));
        return encodedSrgb(pow(mix(ground, sky, smoothstep(-0.03, 0.03, height)), vec3(2.2)) + 0.8 * pow(key, 60.0));
    }
    if (frame.lookKind == LOOK_PEARL) {
        vec3 hue = 0.62 + 0.16 * cos(6.28318 * (0.7 * ball.z + vec3(0.0, 0.33, 0.67)));
        return encodedSrgb(hue * (0.35 + 0.6 * key) + 0.35 * rim + 0.25 * pow(key, 30.0));
    }
    vec3 clay = vec3(0.46, 0.27, 0.20);
    return encodedSrgb(clay * (0.18 + 0.95 * key * key + 0.25 * max(ball.y, 0.0)) + 0.10 * rim + 0.08 * pow(key, 24.0));
}

layout(set = 0, binding = BINDING_SPAN_PLACES, scalar) readonly buffer SpanPlaceBuffer { float spanPlaces[]; };

// Squares along one parameter: 1 and -1 in turn.
float squares(uint start, float t, vec2 along)
{
    float size = spanPlaces[start + 1u] - spanPlaces[start];
    float scale = 0.5 * frame.lookCount;  // a stripe and the next one are one period
    float width = clamp(scale * size * length(along), 1e-4, 1e4);
    return 2.0 * evenStripes(scale * (spanPlaces[start] + size * t), width) - 1.0;
}

vec3 checker(uint surface, ExactPoint at, vec3 inside)
{
    uint number = at.place.ksquad - surfaces[surface].firstKsquad;
    uint spansV = surfaces[surface].spansV;
    uint first = surfaces[surface].firstBorder / 2u + 2u * surface;
    float u = squares(first + number / spansV, at.place.t.x, vec2(at.placeAlong[0].x, at.placeAlong[1].x));
    float v = squares(first + surfaces[surface].spansU + 1u + number % spansV, at.place.t.y,
                      vec2(at.placeAlong[0].y, at.placeAlong[1].y));
    return mix(vec3(0.22, 0.26, 0.32), vec3(0.90, 0.89, 0.85), 0.5 + 0.5 * u * v) * inside;
}

float curvatureFigure(ExactPoint at)
{
    if (frame.lookKind == LOOK_GAUSS)
        return at.gauss;
    if (frame.lookKind == LOOK_LARGEST)
        return at.mean + at.apart;
    if (frame.lookKind == LOOK_SMALLEST)
        return at.mean - at.apart;
    return at.mean;
}

vec3 numberColour(float number)
{
    float place = (number - frame.lookRange.x) / (frame.lookRange.y - frame.lookRange.x);
    return abs(number) <= 3.0e38 ? rampColour(place) : noNumberColour();
}

layout(set = 0, binding = BINDING_DEVIATIONS, scalar) readonly buffer DeviationBuffer { uint deviations[]; };

float deviationValue(uint at) { return uintBitsToFloat(deviations[at]); }

// Interpolated on the KSQuad's grid; no number where it has none.
float deviationAt(PixelPlace place)
{
    uint start = deviations[place.ksquad];
    if (start == 0u)
        return 3.4e38;
    uint cells = deviations[start];
    vec2 at = clamp(place.t, 0.0, 1.0) * float(cells);
    uvec2 cell = min(uvec2(at), uvec2(cells - 1u));
    vec2 share = at - vec2(cell);
    uint row = start + 1u + cell.x * (cells + 1u) + cell.y;
    uint next = row + cells + 1u;
    return mix(mix(deviationValue(row), deviationValue(row + 1u), share.y),
               mix(deviationValue(next), deviationValue(next + 1u), share.y), share.x);
}

// How far the surface leans from the direction in which a mould is pulled: 0 degrees where it is parallel to it.
float draftDegrees(vec3 normal)
{
    return degrees(atan(dot(normal, frame.lookAxis), length(cross(normal, frame.lookAxis))));
}
