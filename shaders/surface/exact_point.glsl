// The exact surface at a pixel: not what vertices say, however few they are.
//
// Nothing here or in looks.glsl takes differences between pixels: at a triangle's edge the pixels beside it are of no use
// (the software driver does not run loops for them), and derivatives of the surface say it exactly.

#include "../shared/pixel_aim.glsl"

// In eye-relative view space.
struct ExactPoint {
    PixelPlace place;
    vec3 position;
    vec3 normal;  // unit; S_u x S_v, turned where the transform mirrors
    float gauss;  // by that normal; not finite where the surface tells none
    float mean;
    float apart;  // the principal curvatures are mean + apart and mean - apart
    // From this pixel to the next one along x and along y: how place.t changes, the position, the normal.
    vec2 placeAlong[2];
    vec3 positionAlong[2];
    vec3 normalAlong[2];
};

BentSample bentSample(KsQuadRecord ksquad, vec2 t)
{
    uint surface = ksquad.surface;
    int degreeU = int(surfaces[surface].degreeU);
    int degreeV = int(surfaces[surface].degreeV);
    return contractBentNet(ksquad.firstPoint, surfaces[surface].stride, degreeU, degreeV,
                           evaluateBentBasis(ksquad.spanU, degreeU, t.x), evaluateBentBasis(ksquad.spanV, degreeV, t.y));
}

// Derivatives of the point by t, in view space.
struct Derivatives {
    vec3 u;
    vec3 v;
    vec3 uu;
    vec3 uv;
    vec3 vv;
};

float safeLength(vec3 v)
{
    float scale = largest(v);  // squares of very small or large numbers would leave float
    return scale > 0.0 ? scale * length(v / scale) : 0.0;
}

// As model/analysis/curvature.cpp has it: the second fundamental form in an orthonormal frame is a symmetric matrix whose
// eigenvalues are the principal curvatures (do Carmo, 3.3).
void bend(inout ExactPoint at, Derivatives by)
{
    float sizeU = safeLength(by.u);
    float sizeV = safeLength(by.v);
    float cosine = dot(by.u / sizeU, by.v / sizeV);
    float sine = length(cross(by.u / sizeU, by.v / sizeV));
    float uu = dot(by.uu / sizeU, at.normal) / sizeU;
    float uv = dot(by.uv / sizeU, at.normal) / sizeV;
    float vv = dot(by.vv / sizeV, at.normal) / sizeV;
    float b = (uv - cosine * uu) / sine;
    float c = (vv - cosine * (2.0 * uv - cosine * uu)) / (sine * sine);
    at.mean = 0.5 * (uu + c);
    at.apart = length(vec2(0.5 * (uu - c), b));
    at.gauss = uu * c - b * b;
}

// What changes from pixel to pixel.
void slope(inout ExactPoint at, Derivatives by, Aim aim)
{
    float sizeU = safeLength(by.u);
    float sizeV = safeLength(by.v);
    vec3 u = by.u / sizeU;
    vec3 v = by.v / sizeV;
    vec3 product = cross(u, v);
    // Of the product of those directions, whose own lengths do not count.
    vec3 alongU = cross(by.uu / sizeU, v) + cross(u, by.uv / sizeV);
    vec3 alongV = cross(by.uv / sizeU, v) + cross(u, by.vv / sizeV);
    float side = dot(product, at.normal) < 0.0 ? -1.0 : 1.0;
    for (int k = 0; k < 2; ++k) {
        vec2 step = aim.along[k];
        at.placeAlong[k] = step;
        at.positionAlong[k] = by.u * step.x + by.v * step.y;
        vec3 turning = side * (alongU * step.x + alongV * step.y) / length(product);
        at.normalAlong[k] = turning - at.normal * dot(at.normal, turning);
    }
}

// By Newton's method from the triangle's parameters, which belong to a point beside the pixel, for the triangle lies beside
// the surface.
ExactPoint exactPoint(uint surface, vec2 t)
{
    // As placedVertex() has it: where tangents are so short that rounding turns them, a place further inside counts.
    const float kLeastTangent = 1024.0 * KNOTSPAN_ROUNDING;
    const float kLeastSine = 1024.0 * KNOTSPAN_ROUNDING;
    const float kNearEnough = 1.0 / 64.0;  // pixels
    const int kMostSteps = 3;
    mat3 turn = mat3(surfaceViews[surface].modelView);
    ExactPoint best;
    ExactPoint tried;
    tried.place = pixelPlace(t);
    PixelPlace start = tried.place;
    float least = 3.0e38;
    float inwards = 0.0;
    // One loop, so that the evaluation stands in the stage once.
    for (int round = 0; round < 7; ++round) {
        BentSample at = bentSample(ksquads[tried.place.ksquad], tried.place.t);
        Derivatives by = Derivatives(turn * at.du, turn * at.dv, turn * at.duu, turn * at.duv, turn * at.dvv);
        vec3 n = cross(directionOf(by.u), directionOf(by.v));
        tried.position = toView(surface, at.position);
        tried.normal = directionOf(n) * surfaceViews[surface].facing;
        float shortest = min(largest(by.u), largest(by.v));
        bool tells = shortest > kLeastTangent * largest(turn * at.position) && dot(n, n) > kLeastSine * kLeastSine;
        Aim aim = aimOf(gl_FragCoord.xy, tried.position, by.u, by.v);
        float missed = length(aim.missed);
        // A step may have gone too far: beyond a pole the surface goes on turned over.
        if (round > 0 && inwards == 0.0 && !(tells && missed < least && dot(best.normal, tried.normal) > 0.0))
            break;
        bend(tried, by);
        slope(tried, by, aim);
        best = tried;
        if (tells) {
            least = missed;
            if (inwards > 0.0 || missed < kNearEnough || round == kMostSteps)
                break;
            tried.place = stepped(surface, tried.place, aim.along[0] * aim.missed.x + aim.along[1] * aim.missed.y);
            continue;
        }
        inwards = max(8.0 * inwards, 0.0009765625);
        tried.place = PixelPlace(start.ksquad, mix(start.t, vec2(0.5), inwards));
    }
    return best;
}
