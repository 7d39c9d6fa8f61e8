// Whether a point of a KSQuad is inside its surface's trim loops: exactly by their curves, few of which it looks at.
//
// After Schollmeyer and Froehlich, Direct trimming of NURBS surfaces on the GPU (2009), and Efficient and anti-aliased
// trimming for rendering large NURBS models (2018): curves that are monotone in u and in v, in bands (parts of v) and in
// each band in cells (parts of u). Between the cells no curve runs. A point is inside where an odd number of curves lies to
// its left; a cell knows whether that is so at its own left border.
//
// One array of words, made by model/trimming/trim_index.h. First a word for each KSQuad: TRIM_INSIDE, TRIM_OUTSIDE,
// TRIM_WHOLE, or where its record starts; places within a record count from there:
//     TRIM_ROWS words, a row of the KSQuad each: for each of as many squares in it two bits, whether all of it is TRIM_INSIDE,
//         TRIM_OUTSIDE, or TRIM_NEAR to a curve
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
#define TRIM_WHOLE 2u    // inside, and the surface has no loops
#define TRIM_RECORDS 3u  // what is not below is where a record starts
#define TRIM_NEAR 3u     // of a box: a curve may run through it
#define TRIM_RATIONAL 256u
#define TRIM_ROWS 16
#define TRIM_ALL_OUTSIDE 0x55555555u  // a row
#define TRIM_STEPS 16  // halvings of a piece: what is left of it is straight, as far as float tells
#define TRIM_BELOW_ONE 0.99999994f
#define TRIM_MOST_BANDS 4  // that are looked at for one box

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

// A piece, read once: places are asked for many times, and memory answers slowly. Up to degree 3 as a cubic.
struct TrimPiece {
    uint start;
    uint kind;
    vec2 first;
    vec2 last;
    vec3 inner[2];  // with weights, times 3
};

KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE TrimPiece trimPieceEnds(KNOTSPAN_SOURCE uint start)
{
    TrimPiece piece;
    piece.start = start;
    piece.kind = KNOTSPAN_TRIM_WORD(start);
    piece.first = trimPoint(KNOTSPAN_PASS_SOURCE start + 1u);
    piece.last = trimPoint(KNOTSPAN_PASS_SOURCE start + 3u);
    return piece;
}

KNOTSPAN_INLINE bool trimIsLine(TrimPiece piece) { return (piece.kind & 255u) == 1u; }

KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE vec3 trimInner(KNOTSPAN_SOURCE TrimPiece piece, uint k)
{
    bool rational = (piece.kind & TRIM_RATIONAL) != 0u;
    uint at = piece.start + 5u + k * (rational ? 3u : 2u);
    vec2 point = trimPoint(KNOTSPAN_PASS_SOURCE at);
    float weight = rational ? trimNumber(KNOTSPAN_PASS_SOURCE at + 2u) : 1.0f;
    return vec3(point.x, point.y, 1.0f) * weight;
}

// Before places are asked for; of lines none are.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE void trimHoldInner(KNOTSPAN_SOURCE KNOTSPAN_INOUT(TrimPiece) piece)
{
    uint degree = piece.kind & 255u;
    if (degree == 2u) {
        vec3 middle = trimInner(KNOTSPAN_PASS_SOURCE piece, 0u) * 2.0f;
        piece.inner[0] = vec3(piece.first.x, piece.first.y, 1.0f) + middle;
        piece.inner[1] = vec3(piece.last.x, piece.last.y, 1.0f) + middle;
    } else if (degree == 3u) {
        piece.inner[0] = trimInner(KNOTSPAN_PASS_SOURCE piece, 0u) * 3.0f;
        piece.inner[1] = trimInner(KNOTSPAN_PASS_SOURCE piece, 1u) * 3.0f;
    }
}

// The point of a piece at s of 0 to 1: sums of numbers that are not negative (The NURBS Book, A1.6 and Horner's rule).
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE vec2 trimPlace(KNOTSPAN_SOURCE TrimPiece piece, float s)
{
    uint degree = piece.kind & 255u;
    float r = 1.0f - s;
    float power = 1.0f;
    vec3 sum = vec3(piece.first.x, piece.first.y, 1.0f) * r;
    if (degree <= 3u) {
        sum = (((sum + piece.inner[0] * s) * r) + piece.inner[1] * (s * s)) * r;
        power = s * s;
    } else {
        float binomial = 1.0f;
        for (uint k = 1u; k < degree; ++k) {
            power *= s;
            binomial *= float(degree - k + 1u) / float(k);
            sum = (sum + trimInner(KNOTSPAN_PASS_SOURCE piece, k - 1u) * (binomial * power)) * r;
        }
    }
    sum += vec3(piece.last.x, piece.last.y, 1.0f) * (power * s);
    return vec2(sum.x, sum.y) / sum.z;
}

// Whether a piece lies to the left of the point, at the point's height.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimPieceCrosses(KNOTSPAN_SOURCE TrimPiece piece, vec2 t)
{
    bool rises = piece.first.y <= piece.last.y;
    vec2 low = rises ? piece.first : piece.last;
    vec2 high = rises ? piece.last : piece.first;
    // Of the ends one counts, so that of two pieces that meet exactly one does.
    if (t.y < low.y || t.y >= high.y)
        return false;
    if (t.x < min(low.x, high.x))
        return false;
    if (t.x >= max(low.x, high.x))
        return true;
    float below = rises ? 0.0f : 1.0f;
    float above = 1.0f - below;
    int steps = trimIsLine(piece) ? 0 : TRIM_STEPS;
    if (steps > 0)
        trimHoldInner(KNOTSPAN_PASS_SOURCE piece);
    for (int step = 0; step < steps; ++step) {
        float s = 0.5f * (below + above);
        vec2 at = trimPlace(KNOTSPAN_PASS_SOURCE piece, s);
        if (at.y <= t.y) {
            low = at;
            below = s;
        } else {
            high = at;
            above = s;
        }
        // What is left of the piece lies in the box of its ends.
        if (t.x < min(low.x, high.x))
            return false;
        if (t.x >= max(low.x, high.x))
            return true;
    }
    return (t.x - low.x) * (high.y - low.y) >= (t.y - low.y) * (high.x - low.x);
}

KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimCrosses(KNOTSPAN_SOURCE uint start, vec2 t)
{
    return trimPieceCrosses(KNOTSPAN_PASS_SOURCE trimPieceEnds(KNOTSPAN_PASS_SOURCE start), t);
}

// Of a KSQuad's record.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimRecordContains(KNOTSPAN_SOURCE uint record, vec2 t)
{
    t.y = min(t.y, TRIM_BELOW_ONE);  // the upper border belongs to the KSQuad
    uint bands = KNOTSPAN_TRIM_WORD(record + uint(TRIM_ROWS));
    uint first = record + uint(TRIM_ROWS) + 1u;
    uint band = first + 3u * trimEntry(KNOTSPAN_PASS_SOURCE first, 3u, bands, t.y);
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

// What the rows say of a box.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE uint trimRowSide(KNOTSPAN_SOURCE uint record, vec2 low, vec2 high)
{
    const float kRows = float(TRIM_ROWS);
    uint left = uint(min(max(low.x * kRows, 0.0f), kRows - 1.0f));
    uint right = uint(min(max(high.x * kRows, 0.0f), kRows - 1.0f));
    uint bottom = uint(min(max(low.y * kRows, 0.0f), kRows - 1.0f));
    uint top = uint(min(max(high.y * kRows, 0.0f), kRows - 1.0f));
    uint squares = (0xffffffffu >> (2u * (uint(TRIM_ROWS) - 1u - right + left))) << (2u * left);
    uint notInside = 0u;
    uint notOutside = 0u;
    for (uint row = bottom; row <= top; ++row) {
        uint word = KNOTSPAN_TRIM_WORD(record + row);
        notInside |= word & squares;
        notOutside |= (word ^ TRIM_ALL_OUTSIDE) & squares;
    }
    if (notInside == 0u)
        return TRIM_INSIDE;
    return notOutside == 0u ? TRIM_OUTSIDE : TRIM_NEAR;
}

// `t`: 0 to 1 across the KSQuad of that number.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimContains(KNOTSPAN_SOURCE uint ksquad, vec2 t)
{
    uint record = KNOTSPAN_TRIM_WORD(ksquad);
    if (record < TRIM_RECORDS)
        return record != TRIM_OUTSIDE;
    uint square = trimRowSide(KNOTSPAN_PASS_SOURCE record, t, t);
    return square == TRIM_NEAR ? trimRecordContains(KNOTSPAN_PASS_SOURCE record, t) : square == TRIM_INSIDE;
}

// A box around t that may reach into other bands: from `low` to `high`.
struct TrimBox {
    vec2 t;
    vec2 low;
    vec2 high;
};

// Whether a piece lies to the left of t, at t's height: 0 or 1; TRIM_NEAR where it may run through the box, which lies in
// one band.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE uint trimPasses(KNOTSPAN_SOURCE uint start, TrimBox box)
{
    TrimPiece piece = trimPieceEnds(KNOTSPAN_PASS_SOURCE start);
    bool rises = piece.first.y <= piece.last.y;
    vec2 low = rises ? piece.first : piece.last;
    vec2 high = rises ? piece.last : piece.first;
    if (box.high.y < low.y || box.low.y > high.y)
        return 0u;
    uint left = box.t.y >= low.y && box.t.y < high.y ? 1u : 0u;
    float bottom = max(box.low.y, low.y);
    float top = min(box.high.y, high.y);
    bool isLine = trimIsLine(piece);
    if (isLine && high.y > low.y) {
        vec2 corner = low;
        float slope = (high.x - low.x) / (high.y - low.y);
        low = vec2(corner.x + slope * (bottom - corner.y), bottom);
        high = vec2(corner.x + slope * (top - corner.y), top);
    }
    float below = rises ? 0.0f : 1.0f;
    float above = 1.0f - below;
    int steps = isLine ? 0 : TRIM_STEPS;
    if (!isLine)
        trimHoldInner(KNOTSPAN_PASS_SOURCE piece);
    for (int step = 0; step < steps; ++step) {
        if (box.high.x < min(low.x, high.x))
            return 0u;
        if (box.low.x > max(low.x, high.x))
            return left;
        float s = 0.5f * (below + above);
        vec2 at = trimPlace(KNOTSPAN_PASS_SOURCE piece, s);
        if (bottom > at.y) {
            low = at;
            below = s;
        } else if (top < at.y) {
            high = at;
            above = s;
        } else {
            return TRIM_NEAR;
        }
    }
    if (box.high.x < min(low.x, high.x))
        return 0u;
    return box.low.x > max(low.x, high.x) ? left : TRIM_NEAR;
}

// Of the part of the box that lies in one band, `next`: where the band above starts.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE uint trimBandSide(KNOTSPAN_SOURCE uint record, uint band, float next, TrimBox box)
{
    float bottom = trimNumber(KNOTSPAN_PASS_SOURCE band);
    box.low.y = max(box.low.y, bottom);
    box.high.y = min(box.high.y, next);
    box.t.y = min(max(box.t.y, box.low.y), box.high.y);
    uint count = KNOTSPAN_TRIM_WORD(band + 2u);
    uint inside = count & 1u;
    count = count >> 1u;
    if (count == 0u)
        return 1u - inside;
    uint cells = record + KNOTSPAN_TRIM_WORD(band + 1u);
    uint cell = cells + 4u * trimEntry(KNOTSPAN_PASS_SOURCE cells, 4u, count, box.high.x);
    if (box.high.x < trimNumber(KNOTSPAN_PASS_SOURCE cell))
        return 1u - inside;
    uint pieces = KNOTSPAN_TRIM_WORD(cell + 3u);
    if (box.low.x > trimNumber(KNOTSPAN_PASS_SOURCE cell + 1u))
        return (pieces & 2u) != 0u ? TRIM_INSIDE : TRIM_OUTSIDE;
    if (cell != cells && box.low.x <= trimNumber(KNOTSPAN_PASS_SOURCE cell - 3u))
        return TRIM_NEAR;  // the cell before it, too
    inside = pieces & 1u;
    uint list = record + KNOTSPAN_TRIM_WORD(cell + 2u);
    for (uint k = 0u; k < pieces >> 2u; ++k) {
        uint left = trimPasses(KNOTSPAN_PASS_SOURCE record + KNOTSPAN_TRIM_WORD(list + k), box);
        if (left == TRIM_NEAR)
            return TRIM_NEAR;
        inside ^= left;
    }
    return 1u - inside;
}

// TRIM_INSIDE or TRIM_OUTSIDE where that holds for all places of a KSQuad within `reach` of t, else TRIM_NEAR: then
// trimContains() knows. The box must not leave the KSQuad. Says TRIM_NEAR too often rather than too rarely.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE uint trimSide(KNOTSPAN_SOURCE uint ksquad, vec2 t, vec2 reach)
{
    uint record = KNOTSPAN_TRIM_WORD(ksquad);
    if (record < TRIM_RECORDS)
        return record == TRIM_OUTSIDE ? TRIM_OUTSIDE : TRIM_INSIDE;
    TrimBox box;
    box.t = t;
    box.low = t - reach;
    box.high = t + reach;
    uint side = trimRowSide(KNOTSPAN_PASS_SOURCE record, box.low, box.high);
    if (side != TRIM_NEAR)
        return side;
    uint bands = KNOTSPAN_TRIM_WORD(record + uint(TRIM_ROWS));
    uint entries = record + uint(TRIM_ROWS) + 1u;
    uint first = trimEntry(KNOTSPAN_PASS_SOURCE entries, 3u, bands, box.low.y);
    for (uint k = 0u; k <= uint(TRIM_MOST_BANDS); ++k) {
        uint band = entries + 3u * (first + k);
        bool isLast = first + k + 1u == bands;
        float next = isLast ? 1.0f : trimNumber(KNOTSPAN_PASS_SOURCE band + 3u);
        uint here = k == uint(TRIM_MOST_BANDS) ? TRIM_NEAR : trimBandSide(KNOTSPAN_PASS_SOURCE record, band, next, box);
        if (here == TRIM_NEAR || (k > 0u && here != side))
            return TRIM_NEAR;
        side = here;
        if (isLast || next > box.high.y)
            break;
    }
    return side;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
