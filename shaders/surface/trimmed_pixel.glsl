// Pixels of which trim loops leave nothing: they get no colour, no index and no depth. Stages that know of them are compiled
// with KNOTSPAN_TRIMMED, and drawn with where a surface is trimmed.
//
// Where the border of what is left runs near the pixel's centre, the colour's opacity says where (trim_edge.glsl), for the
// stage that smooths it.
//
// Differences between pixels are to be taken before: a discarded pixel has none, and the software driver runs no loops for
// the pixels beside a triangle.
#ifdef KNOTSPAN_TRIMMED
layout(set = 0, binding = BINDING_TRIM_WORDS, scalar) readonly buffer TrimBuffer { uint trimWords[]; };

#include "../shared/trimming.glsl"
#include "pixel_aim.glsl"
#include "trim_edge.glsl"

// Beyond that nobody takes it for a tolerance.
const float kMostMissed = 4.0;
// A flat surface's triangles are the surface itself.
bool isFlat(uint surface) { return max(surfaces[surface].degreeU, surfaces[surface].degreeV) == 1u; }
// A pixel, and what the triangle may lie beside the surface.
float reachPx(uint surface) { return TRIM_EDGE_REACH + (isFlat(surface) ? 0.0 : min(frame.tolerancePx, kMostMissed)); }

// Parameters run the way that the tolerance is about (surface_io.glsl).
vec2 aimedT() { return inInverseWeight > 0.0 ? inWeightedT / inInverseWeight : inT; }
mat2 aimedChanges() { return mat2(dFdx(aimedT()), dFdy(aimedT())); }

// What a record's squares say of a box, finer ones of a smaller box.
uint boxSide(uint record, vec2 low, vec2 high)
{
    const uint kWord = uint(TRIM_SQUARES);
    const vec2 kMost = vec2(16.0, 2.0);  // squares that a box is across: those beside each other cost little
    TrimSquares squares = trimSquares(record);
    uvec2 doublings = uvec2(squares.columns, squares.rows);
    vec2 across = (high - low) * vec2(uvec2(TRIM_SQUARES) << doublings) / kMost;
    vec2 halvings = min(ceil(log2(max(across, 1.0))), vec2(doublings));
    for (uint k = uint(max(halvings.x, halvings.y)); k > 0u; --k) {
        squares.start += uint(TRIM_SQUARES) << (doublings.x + doublings.y);
        doublings = max(doublings, 1u) - 1u;
    }
    uint left = trimSquareAt(low.x, doublings.x);
    uint right = trimSquareAt(high.x, doublings.x);
    uint top = trimSquareAt(high.y, doublings.y);
    uint notInside = 0u;
    uint notOutside = 0u;
    for (uint row = trimSquareAt(low.y, doublings.y); row <= top; ++row)
        for (uint part = left / kWord; part <= right / kWord; ++part) {
            uint first = max(left, kWord * part) - kWord * part;
            uint last = min(right - kWord * part, kWord - 1u);
            uint asked = (0xffffffffu >> (2u * (kWord - 1u - last + first))) << (2u * first);
            uint word = trimWords[squares.start + (row << doublings.x) + part];
            notInside |= word & asked;
            notOutside |= (word ^ TRIM_ALL_OUTSIDE) & asked;
        }
    if (notInside == 0u)
        return TRIM_INSIDE;
    return notOutside == 0u ? TRIM_OUTSIDE : TRIM_NEAR;
}

// What loops leave of all places that this pixel and its neighbours may show: TRIM_INSIDE, TRIM_OUTSIDE, or TRIM_NEAR.
// Looks at words only that hold for many places.
uint sideAround(PixelPlace place, uint word, vec2 reach)
{
    bool isWithin = all(greaterThan(place.t, reach)) && all(lessThan(place.t, 1.0 - reach));
    if (word >= TRIM_RECORDS)
        return boxSide(word, place.t - reach, place.t + reach);
    if (isWithin)
        return word;
    uint surface = ksquads[place.ksquad].surface;
    for (int k = 0; k < 4; ++k) {
        vec2 corner = reach * vec2((k & 1) != 0 ? 1.0 : -1.0, (k & 2) != 0 ? 1.0 : -1.0);
        if (trimWords[stepped(surface, place, corner).ksquad] != word)
            return TRIM_NEAR;
    }
    return word;
}

// The triangle lies beside the surface, by as much as the tolerance: one step towards the pixel's centre, so that surfaces
// that meet along a loop leave no pixel between them, however each is cut into triangles.
// `along`: how t changes from pixel to pixel there.
PixelPlace aimedPlace(uint surface, PixelPlace place, inout mat2 along)
{
    const float kMostChange = 0.5;  // of a KSQuad
    if (isFlat(surface))
        return place;
    SurfaceSample at = sampleKsQuad(ksquads[place.ksquad], place.t);
    mat3 turn = mat3(surfaceViews[surface].modelView);
    Aim aim = aimOf(toView(surface, at.position), turn * at.du, turn * at.dv);
    vec2 change = aim.along[0] * aim.missed.x + aim.along[1] * aim.missed.y;
    if (!(length(aim.missed) < kMostMissed && max(abs(change.x), abs(change.y)) < kMostChange))
        return place;
    along = mat2(aim.along[0], aim.along[1]);
    return stepped(surface, place, change);
}

// Where loops leave nothing of the pixel's centre. `along`: how aimedT() changes from pixel to pixel.
void discardSharply(PixelPlace place, uint word, mat2 along)
{
    uint side = word < TRIM_RECORDS ? word : trimSquareSide(word, place.t);
    if (side == TRIM_OUTSIDE)
        discard;
    if (side != TRIM_NEAR)
        return;
    place = aimedPlace(ksquads[place.ksquad].surface, place, along);
    if (!trimContains(place.ksquad, clamp(place.t, 0.0, 1.0)))
        discard;
}

// The same, and the colour's opacity.
float discardSmoothly(PixelPlace place, uint word, mat2 along)
{
    // A loop through the very centre leaves the pixel to both of two that meet there, rather than to neither.
    const float kRounding = 0.02;
    uint surface = ksquads[place.ksquad].surface;
    uint side = sideAround(place, word, reachPx(surface) * (abs(along[0]) + abs(along[1])));
    if (side == TRIM_OUTSIDE)
        discard;
    if (side != TRIM_NEAR)
        return 1.0;
    place = aimedPlace(surface, place, along);
    word = trimWords[place.ksquad];
    PlaceInLoops found = PlaceInLoops(word != TRIM_OUTSIDE, FAR_FROM_EDGES);
    if (word >= TRIM_RECORDS)
        found = placeInLoops(word, clamp(place.t, 0.0, 1.0), inverse(along),
                             TRIM_EDGE_REACH * (abs(along[0]) + abs(along[1])));
    vec4 around = found.distances;
    if (!found.inside && min(min(around.x, around.y), min(around.z, around.w)) > kRounding)
        discard;
    return opacityAt(surface, place, along, around);
}

float discardTrimmed(mat2 along)
{
    PixelPlace place = pixelPlace(aimedT());
    uint word = trimWords[place.ksquad];
    if (word == TRIM_WHOLE)
        return 1.0;
    if ((frame.flags & FRAME_SHARP_EDGES) == 0u)
        return discardSmoothly(place, word, along);
    discardSharply(place, word, along);
    return 1.0;
}
#else
mat2 aimedChanges() { return mat2(0.0); }
float discardTrimmed(mat2 along) { return 1.0; }
#endif
