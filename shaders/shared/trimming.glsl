// Whether a point of a KSQuad is inside its surface's trim loops: exactly by their curves, few of which it looks at.
//
// After Schollmeyer and Froehlich, Direct trimming of NURBS surfaces on the GPU (2009), and Efficient and anti-aliased
// trimming for rendering large NURBS models (2018): curves that are monotone in u and in v, in bands (parts of v) and in
// each band in cells (parts of u). Between the cells no curve runs. A point is inside where an odd number of curves lies to
// its left; a cell knows whether that is so at its own left border.
//
// One array of words, made by model/trimming/trim_index.h. First a word for each KSQuad: TRIM_INSIDE, TRIM_OUTSIDE, or
// where its record starts; places within a record count from there:
//     how many bands; then for each band, rising
//         float where it starts (0 for the first); where its cells start; 2 x how many + 1 where its left end is inside
//     cells: float start and end; where its pieces are listed; 4 x how many + 2 (right end inside) + 1 (left end)
//     lists of pieces: where each starts
//     pieces: degree, TRIM_RATIONAL; x and y of the first point, of the last one; x, y and, if rational, weight of those
//     between. The first and the last one have the weight 1.
#ifndef KNOTSPAN_TRIMMING_GLSL
#define KNOTSPAN_TRIMMING_GLSL

#include "language.h"

#ifdef __cplusplus
#include <glm/gtc/type_precision.hpp>

#include <cstring>

namespace knotspan::gpu {
inline float uintBitsToFloat(uint word)
{
    float number = 0;
    std::memcpy(&number, &word, sizeof number);
    return number;
}
#define KNOTSPAN_TRIM_WORD(index) source.trimWord(index)
#else
#define KNOTSPAN_TRIM_WORD(index) trimWords[index]
#endif

#define TRIM_INSIDE 0u
#define TRIM_OUTSIDE 1u
#define TRIM_RATIONAL 256u
#define TRIM_STEPS 16  // halvings of a piece: what is left of it is straight, as far as float tells
#define TRIM_BELOW_ONE 0.99999994f

KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE float trimNumber(KNOTSPAN_SOURCE uint index)
{
    return uintBitsToFloat(KNOTSPAN_TRIM_WORD(index));
}

KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE vec2 trimPoint(KNOTSPAN_SOURCE uint index)
{
    return vec2(trimNumber(KNOTSPAN_PASS_SOURCE index), trimNumber(KNOTSPAN_PASS_SOURCE index + 1u));
}

// Of the last entry, `stride` words each, whose first word is not above `at`; 0 where none is. `first` is that of entry 0.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE uint trimEntry(KNOTSPAN_SOURCE uint first, uint stride, uint count, float at)
{
    uint low = 0u;
    uint high = count;
    while (high - low > 1u) {
        uint middle = (low + high) / 2u;
        if (trimNumber(KNOTSPAN_PASS_SOURCE first + stride * middle) <= at)
            low = middle;
        else
            high = middle;
    }
    return low;
}

// The point of a piece at s of 0 to 1: sums of numbers that are not negative (The NURBS Book, A1.6 and Horner's rule).
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE vec2 trimPlace(KNOTSPAN_SOURCE uint piece, vec2 first, vec2 last, float s)
{
    uint kind = KNOTSPAN_TRIM_WORD(piece);
    uint degree = kind & 255u;
    bool rational = (kind & TRIM_RATIONAL) != 0u;
    float r = 1.0f - s;
    float power = 1.0f;
    float binomial = 1.0f;
    vec3 sum = vec3(first.x, first.y, 1.0f) * r;
    uint at = piece + 5u;
    for (uint k = 1u; k < degree; ++k) {
        power *= s;
        binomial *= float(degree - k + 1u) / float(k);
        vec2 point = trimPoint(KNOTSPAN_PASS_SOURCE at);
        float weight = rational ? trimNumber(KNOTSPAN_PASS_SOURCE at + 2u) : 1.0f;
        sum = (sum + vec3(point.x, point.y, 1.0f) * (weight * binomial * power)) * r;
        at += rational ? 3u : 2u;
    }
    sum += vec3(last.x, last.y, 1.0f) * (power * s);
    return vec2(sum.x, sum.y) / sum.z;
}

// Whether a piece lies to the left of the point, at the point's height.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimCrosses(KNOTSPAN_SOURCE uint piece, vec2 t)
{
    vec2 first = trimPoint(KNOTSPAN_PASS_SOURCE piece + 1u);
    vec2 last = trimPoint(KNOTSPAN_PASS_SOURCE piece + 3u);
    bool rises = first.y <= last.y;
    vec2 low = rises ? first : last;
    vec2 high = rises ? last : first;
    // Of the ends one counts, so that of two pieces that meet exactly one does.
    if (t.y < low.y || t.y >= high.y)
        return false;
    float below = rises ? 0.0f : 1.0f;
    float above = 1.0f - below;
    int steps = (KNOTSPAN_TRIM_WORD(piece) & 255u) == 1u ? 0 : TRIM_STEPS;
    for (int step = 0; step < steps; ++step) {
        // What is left of the piece lies in the box of its ends.
        if (t.x < min(low.x, high.x))
            return false;
        if (t.x >= max(low.x, high.x))
            return true;
        float s = 0.5f * (below + above);
        vec2 at = trimPlace(KNOTSPAN_PASS_SOURCE piece, first, last, s);
        if (at.y <= t.y) {
            low = at;
            below = s;
        } else {
            high = at;
            above = s;
        }
    }
    if (t.x < min(low.x, high.x))
        return false;
    if (t.x >= max(low.x, high.x))
        return true;
    return (t.x - low.x) * (high.y - low.y) >= (t.y - low.y) * (high.x - low.x);
}

// Of a KSQuad's record.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimRecordContains(KNOTSPAN_SOURCE uint record, vec2 t)
{
    t.y = min(t.y, TRIM_BELOW_ONE);  // the upper border belongs to the KSQuad
    uint bands = KNOTSPAN_TRIM_WORD(record);
    uint band = record + 1u + 3u * trimEntry(KNOTSPAN_PASS_SOURCE record + 1u, 3u, bands, t.y);
    uint count = KNOTSPAN_TRIM_WORD(band + 2u);
    bool inside = (count & 1u) != 0u;
    count = count >> 1u;
    if (count == 0u)
        return inside;
    uint cells = record + KNOTSPAN_TRIM_WORD(band + 1u);
    uint cell = cells + 4u * trimEntry(KNOTSPAN_PASS_SOURCE cells, 4u, count, t.x);
    if (t.x < trimNumber(KNOTSPAN_PASS_SOURCE cell))
        return inside;
    uint pieces = KNOTSPAN_TRIM_WORD(cell + 3u);
    if (t.x > trimNumber(KNOTSPAN_PASS_SOURCE cell + 1u))
        return (pieces & 2u) != 0u;
    inside = (pieces & 1u) != 0u;
    uint list = record + KNOTSPAN_TRIM_WORD(cell + 2u);
    for (uint k = 0u; k < pieces >> 2u; ++k)
        if (trimCrosses(KNOTSPAN_PASS_SOURCE record + KNOTSPAN_TRIM_WORD(list + k), t))
            inside = !inside;
    return inside;
}

// `t`: 0 to 1 across the KSQuad of that number.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimContains(KNOTSPAN_SOURCE uint ksquad, vec2 t)
{
    uint record = KNOTSPAN_TRIM_WORD(ksquad);
    if (record <= TRIM_OUTSIDE)
        return record == TRIM_INSIDE;
    return trimRecordContains(KNOTSPAN_PASS_SOURCE record, t);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
