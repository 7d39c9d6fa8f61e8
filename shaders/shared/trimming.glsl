// Whether a point of a KSQuad is inside its surface's trim loops: exactly by their curves, few of which it looks at.
//
// After Schollmeyer and Froehlich, Direct trimming of NURBS surfaces on the GPU (2009), and Efficient and anti-aliased
// trimming for rendering large NURBS models (2018): curves that are monotone in u and in v, in bands (parts of v) and in
// each band in cells (parts of u). Between the cells no curve runs. A point is inside where an odd number of curves lies to
// its left; a cell knows whether that is so at its own left border.
//
// One array of words, made by model/trimming/trim_index.h. First a word for each KSQuad: TRIM_INSIDE, TRIM_OUTSIDE,
// TRIM_WHOLE, or where its record starts; places within a record count from there:
//     squares: their shape (TrimSquares), and 64 x where they start
//     how many bands; then for each band, rising
//         float where it starts (0 for the first); where its cells start; 2 x how many + 1 where its left end is inside
//     cells: float start and end; where its pieces are listed; 4 x how many + 2 (right end inside) + 1 (left end)
//     lists of pieces: where each starts
//     pieces: degree, TRIM_RATIONAL; x and y of the first point, of the last one; x, y and, if rational, weight of those
//     between. The first and the last one have the weight 1.
//     squares: words of 16 squares beside each other, two bits each: whether all of it is TRIM_INSIDE, TRIM_OUTSIDE, or
//     TRIM_NEAR to a curve. 16 << columns of them along u, 16 << rows along v, row by row; then the same of half as many
//     along each, but of 16 at least, until both are 16.
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
#define TRIM_SQUARES 16           // of a word
#define TRIM_MOST_DOUBLINGS 4u    // 256 squares along u, or v
#define TRIM_ALL_OUTSIDE 0x55555555u  // a word
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
    uint bands = KNOTSPAN_TRIM_WORD(record + 1u);
    uint first = record + 2u;
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

// Of a record: its squares in finest, and how often those were doubled from 16 along u and along v.
struct TrimSquares {
    uint start;
    uint columns;
    uint rows;
};

KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE TrimSquares trimSquares(KNOTSPAN_SOURCE uint record)
{
    uint word = KNOTSPAN_TRIM_WORD(record);
    TrimSquares squares;
    squares.start = record + (word >> 6u);
    squares.columns = word & 7u;
    squares.rows = (word >> 3u) & 7u;
    return squares;
}

KNOTSPAN_INLINE uint trimSquareAt(float t, uint doublings)
{
    float count = float(uint(TRIM_SQUARES) << doublings);
    return uint(min(max(t * count, 0.0f), count - 1.0f));
}

// What the finest square says that t is in.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE uint trimSquareSide(KNOTSPAN_SOURCE uint record, vec2 t)
{
    TrimSquares squares = trimSquares(KNOTSPAN_PASS_SOURCE record);
    uint column = trimSquareAt(t.x, squares.columns);
    uint row = trimSquareAt(t.y, squares.rows);
    uint word = KNOTSPAN_TRIM_WORD(squares.start + (row << squares.columns) + column / uint(TRIM_SQUARES));
    return (word >> (2u * (column % uint(TRIM_SQUARES)))) & 3u;
}

// `t`: 0 to 1 across the KSQuad of that number.
KNOTSPAN_SCENE_TEMPLATE
KNOTSPAN_INLINE bool trimContains(KNOTSPAN_SOURCE uint ksquad, vec2 t)
{
    uint record = KNOTSPAN_TRIM_WORD(ksquad);
    if (record < TRIM_RECORDS)
        return record != TRIM_OUTSIDE;
    uint square = trimSquareSide(KNOTSPAN_PASS_SOURCE record, t);
    return square == TRIM_NEAR ? trimRecordContains(KNOTSPAN_PASS_SOURCE record, t) : square == TRIM_INSIDE;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
