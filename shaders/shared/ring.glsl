// The triangles between the inside of a KSQuad's drawn grid and its edges (SNAP_RING): the same text for every shader stage
// and for C++.
//
// Two chains of vertices run beside each other, from a common start to a common end; each triangle takes one step along
// one of them, always along the one whose next vertex is less far. Where both have steps no longer than 1/n along the
// direction they run in, every triangle then fits into a length of 1/n: with a the outer and b the inner position and
// a', b' the next ones, a <= b' and b <= a' hold throughout, so a step to a' <= b' spans no more than b .. b' or a .. a'.
//
// A grid at least two cells wide both ways has an inside, whose outermost vertices are one cell from the edges. The outer
// chain goes round the edges from (0, 0) along v = 0, u = 1, v = 1 and u = 0, the inner one beside it. A narrower grid is
// a band without inner vertices: one chain goes along the long side at the start, then across the end; the other across
// the start, then along the other long side. No triangle lies within one side.
#ifndef KNOTSPAN_RING_GLSL
#define KNOTSPAN_RING_GLSL

#include "borders.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

KNOTSPAN_INLINE bool hasInside(DrawnGrid grid)
{
    return grid.u > 1u && grid.v > 1u;
}

// Of a grid that has an inside.
KNOTSPAN_INLINE uint insideVertices(DrawnGrid grid)
{
    return (grid.u - 1u) * (grid.v - 1u);
}
KNOTSPAN_INLINE uint insideCells(DrawnGrid grid)
{
    return (grid.u - 2u) * (grid.v - 2u);
}

KNOTSPAN_INLINE uint loopSide(uint section)
{
    return section == 0u ? SIDE_START_V : (section == 1u ? SIDE_END_U : (section == 2u ? SIDE_END_V : SIDE_START_U));
}

// The sides that a band's chains go along: the outer chain first beside the long direction.
KNOTSPAN_INLINE uint bandSide(DrawnGrid grid, bool outer, uint section)
{
    bool alongV = (grid.u == 1u) == outer;
    if (section == 0u)
        return alongV ? SIDE_START_U : SIDE_START_V;
    return alongV ? SIDE_END_V : SIDE_END_U;
}

KNOTSPAN_INLINE uint innerSteps(DrawnGrid grid, uint section)
{
    return (section & 1u) == 0u ? grid.u - 2u : grid.v - 2u;
}

// Steps of the chains.
KNOTSPAN_INLINE uint outerSteps(DrawnGrid grid)
{
    if (hasInside(grid))
        return grid.edges[0] + grid.edges[1] + grid.edges[2] + grid.edges[3];
    return grid.edges[bandSide(grid, true, 0u)] + grid.edges[bandSide(grid, true, 1u)] - 1u;
}
KNOTSPAN_INLINE uint innerSteps(DrawnGrid grid)
{
    if (hasInside(grid))
        return 2u * (grid.u + grid.v - 4u);
    return grid.edges[bandSide(grid, false, 0u)] + grid.edges[bandSide(grid, false, 1u)] - 1u;
}

// A vertex of a chain: of the section of the chain that ends there or behind it, its step there.
struct ChainPlace {
    uint section;
    uint step;
};

KNOTSPAN_INLINE ChainPlace chainPlace(DrawnGrid grid, bool outer, uint k)
{
    ChainPlace place;
    bool inside = hasInside(grid);
    uint last = inside ? 3u : 1u;
    // The inner chain of a band starts a step behind the common corner.
    place.step = inside || outer ? k : k + 1u;
    for (place.section = 0u; place.section < last; ++place.section) {
        uint steps = inside ? (outer ? grid.edges[loopSide(place.section)] : innerSteps(grid, place.section))
                            : grid.edges[bandSide(grid, outer, place.section)];
        if (place.step <= steps)
            break;
        place.step -= steps;
    }
    return place;
}

// How far along its section a vertex is, or along the band: a fraction, which is exact, or where sides are divided a
// number.
struct ChainPosition {
    uint section;
    uint part;
    uint of;
    float divided;  // less than 0: it is the fraction
};

KNOTSPAN_SCENE_TEMPLATE
float dividedPosition(KNOTSPAN_SOURCE uint ksquad, uint side, uint k)
{
    SurfacePlace place = placeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad);
    BorderSide border = KNOTSPAN_BORDER_SIDE(borderSideIndex(place, side));
    PieceStep at = pieceStep KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE border, k);
    return pieceT(KNOTSPAN_BORDER_PIECE(at.piece), at);
}

KNOTSPAN_SCENE_TEMPLATE
ChainPosition chainPosition(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid, bool outer, uint k)
{
    ChainPlace place = chainPlace(grid, outer, k);
    ChainPosition position;
    position.section = 0u;
    position.part = place.step;
    position.divided = -1.0f;
    uint side = 0u;
    bool backwards = false;
    if (hasInside(grid)) {
        position.section = place.section;
        if (!outer) {
            position.part = place.step + 1u;
            position.of = (place.section & 1u) == 0u ? grid.u : grid.v;
            return position;
        }
        side = loopSide(place.section);
        backwards = place.section > 1u;
    } else {
        side = bandSide(grid, outer, place.section);
        if (outer != (place.section == 0u)) {
            // Across the band: at its start or at its end.
            position.part = outer ? 1u : 0u;
            position.of = 1u;
            return position;
        }
    }
    position.of = grid.edges[side];
    if ((grid.divided >> side & 1u) != 0u) {
        uint step = backwards ? position.of - place.step : place.step;
        float t = dividedPosition KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, side, step);
        position.divided = backwards ? 1.0f - t : t;
    }
    return position;
}

// Whether outer vertex k comes no later than inner vertex j.
KNOTSPAN_SCENE_TEMPLATE
bool outerFirst(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid, uint k, uint j)
{
    // A band's first triangle is that of the common corner.
    if (k == 1u && !hasInside(grid))
        return true;
    ChainPosition a = chainPosition KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, grid, true, k);
    ChainPosition b = chainPosition KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, grid, false, j);
    if (a.section != b.section)
        return a.section < b.section;
    if (a.divided < 0.0f && b.divided < 0.0f)
        return a.part * b.of <= b.part * a.of;
    float farA = a.divided < 0.0f ? float(a.part) / float(a.of) : a.divided;
    float farB = b.divided < 0.0f ? float(b.part) / float(b.of) : b.divided;
    return farA <= farB;
}

// A stretch of the ring: the vertices its triangles are between.
struct RingPart {
    uint outer;  // the first of the outer chain
    uint inner;
    uint outerSteps;
    uint innerSteps;
};

KNOTSPAN_INLINE RingPart wholeRing(DrawnGrid grid)
{
    RingPart part;
    part.outer = 0u;
    part.inner = 0u;
    part.outerSteps = outerSteps(grid);
    part.innerSteps = innerSteps(grid);
    return part;
}

// How many of the first `triangles` of a part take an outer step.
KNOTSPAN_SCENE_TEMPLATE
uint outerStepsOf(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid, RingPart part, uint triangles)
{
    uint low = triangles - min(triangles, part.innerSteps);
    uint high = min(triangles, part.outerSteps);
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (outerFirst KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, grid, part.outer + middle + 1u,
                                          part.inner + triangles - middle))
            low = middle + 1u;
        else
            high = middle;
    }
    return low;
}

// Part number k of a ring cut into `parts`.
KNOTSPAN_SCENE_TEMPLATE
RingPart ringPart(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid, uint parts, uint k)
{
    RingPart whole = wholeRing(grid);
    uint triangles = whole.outerSteps + whole.innerSteps;
    uint start = k * triangles / parts;
    uint end = (k + 1u) * triangles / parts;
    uint outerStart = outerStepsOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, grid, whole, start);
    uint outerEnd = outerStepsOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, grid, whole, end);
    RingPart part;
    part.outer = outerStart;
    part.inner = start - outerStart;
    part.outerSteps = outerEnd - outerStart;
    part.innerSteps = end - start - part.outerSteps;
    return part;
}

// A triangle of a part: the vertices it starts from, and which chain it takes a step along.
struct RingTriangle {
    uint outer;
    uint inner;
    bool stepsOuter;  // else the inner one
};

KNOTSPAN_SCENE_TEMPLATE
RingTriangle ringTriangle(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid, RingPart part, uint number)
{
    uint outer = outerStepsOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, grid, part, number);
    RingTriangle triangle;
    triangle.outer = part.outer + outer;
    triangle.inner = part.inner + number - outer;
    triangle.stepsOuter = outer < part.outerSteps;
    if (triangle.stepsOuter && number - outer < part.innerSteps)
        triangle.stepsOuter = outerFirst KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad, grid, triangle.outer + 1u,
                                                            triangle.inner + 1u);
    return triangle;
}

// Whether the inner chain is to the right of the outer one: triangles (outer, next outer, inner) then run clockwise.
KNOTSPAN_INLINE bool runsClockwise(DrawnGrid grid)
{
    return grid.u == 1u;
}

// Where vertex j of the inner chain is in the grid; of a grid that has an inside.
KNOTSPAN_INLINE uvec2 innerPlace(DrawnGrid grid, uint j)
{
    ChainPlace place = chainPlace(grid, false, j);
    if (place.section == 0u)
        return uvec2(1u + place.step, 1u);
    if (place.section == 1u)
        return uvec2(grid.u - 1u, 1u + place.step);
    return place.section == 2u ? uvec2(grid.u - 1u - place.step, grid.v - 1u) : uvec2(1u, grid.v - 1u - place.step);
}

// Vertex k of a chain.
KNOTSPAN_SCENE_TEMPLATE
GridVertex chainVertex(KNOTSPAN_SOURCE uint ksquad, DrawnGrid grid, bool outer, uint k)
{
    if (!outer && hasInside(grid)) {
        uvec2 at = innerPlace(grid, k);
        return insideVertex(ksquad, grid, at.x, at.y);
    }
    ChainPlace at = chainPlace(grid, outer, k);
    uint side = hasInside(grid) ? loopSide(at.section) : bandSide(grid, outer, at.section);
    uint edge = grid.edges[side];
    uint step = hasInside(grid) && at.section > 1u ? edge - at.step : at.step;
    SurfacePlace place = placeOf KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE ksquad);
    return edgeVertex KNOTSPAN_OF_SOURCE(KNOTSPAN_PASS_SOURCE place, ksquad, side, step, edge);
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
