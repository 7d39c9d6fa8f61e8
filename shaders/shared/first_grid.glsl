// What one window for a whole KSQuad says of its grid, and which windows are to look more closely (grid_choice.glsl).
#ifndef KNOTSPAN_FIRST_GRID_GLSL
#define KNOTSPAN_FIRST_GRID_GLSL

#include "grid_choice.glsl"

#ifdef __cplusplus
namespace knotspan::gpu {
#endif

// What one window for the whole KSQuad tells: a grid that is fine enough for it (GRID_NONE: more than GRID_LARGEST), and
// the least factors that are worth trying with windows of their own.
struct FirstGrid {
    uint u;
    uint v;
    uint leastU;
    uint leastV;
    uint level;  // how closely windows look, 4^level of them a lane; GRID_LEVELS: no window would save a cell
};

// How many windows there are for a lane.
KNOTSPAN_INLINE uint windowsOfLane(FirstGrid first) { return 1u << 2u * first.level; }

// Where one cell may do in a direction, windows there are the whole of it.
KNOTSPAN_INLINE uint windowsAlongU(FirstGrid first)
{
    return first.leastU == 1u ? 1u : (first.leastV == 1u ? GRID_LANES * windowsOfLane(first) : 4u << first.level);
}

KNOTSPAN_TEMPLATE
Stretch KNOTSPAN_OF_REAL stretchAlongU(FirstGrid first, uint number)
{
    uint count = windowsAlongU(first);
    return windowStretch KNOTSPAN_OF_REAL(number % count, count, first.leastU);
}

KNOTSPAN_TEMPLATE
Stretch KNOTSPAN_OF_REAL stretchAlongV(FirstGrid first, uint number)
{
    uint count = windowsAlongU(first);
    return windowStretch KNOTSPAN_OF_REAL(number / count, GRID_LANES * windowsOfLane(first) / count, first.leastV);
}

// The figures of both, each by its own w: the smallest discs around both discs.
KNOTSPAN_TEMPLATE
KNOTSPAN_VEC3 discAroundBoth(KNOTSPAN_VEC2 a, Real radiusA, KNOTSPAN_VEC2 b, Real radiusB)
{
    Real apart = length(b - a);
    if (apart + radiusB <= radiusA)
        return KNOTSPAN_VEC3(a, radiusA);
    if (apart + radiusA <= radiusB)
        return KNOTSPAN_VEC3(b, radiusB);
    Real radius = Real(0.5f) * (apart + radiusA + radiusB);
    return KNOTSPAN_VEC3(a + (b - a) * ((radius - radiusA) / apart), radius * Real(1.000001f));
}

// Divided by its least w.
KNOTSPAN_TEMPLATE
WindowFigures KNOTSPAN_OF_REAL normalised(WindowFigures KNOTSPAN_OF_REAL figures)
{
    Real scale = figures.nearest > Real(0) ? Real(1) / figures.nearest : Real(0);
    figures.a *= scale;
    figures.b *= scale;
    figures.c *= scale;
    figures.spread *= scale;
    figures.inW *= scale;
    figures.nearest = figures.nearest > Real(0) ? Real(1) : Real(0);
    return figures;
}

// Of two that are normalised: a bound for either.
KNOTSPAN_TEMPLATE
WindowFigures KNOTSPAN_OF_REAL joined(WindowFigures KNOTSPAN_OF_REAL one, WindowFigures KNOTSPAN_OF_REAL other)
{
    if (!one.visible)
        return other;
    if (!other.visible)
        return one;
    KNOTSPAN_VEC3 a = discAroundBoth KNOTSPAN_OF_REAL(one.a, one.spread.x, other.a, other.spread.x);
    KNOTSPAN_VEC3 b = discAroundBoth KNOTSPAN_OF_REAL(one.b, one.spread.y, other.b, other.spread.y);
    KNOTSPAN_VEC3 c = discAroundBoth KNOTSPAN_OF_REAL(one.c, one.spread.z, other.c, other.spread.z);
    one.a = KNOTSPAN_VEC2(a);
    one.b = KNOTSPAN_VEC2(b);
    one.c = KNOTSPAN_VEC2(c);
    one.spread = KNOTSPAN_VEC3(a.z, b.z, c.z);
    one.inW = max(one.inW, other.inW);
    one.nearest = min(one.nearest, other.nearest);
    return one;
}

KNOTSPAN_TEMPLATE
uint wholeFactor(Real factor)
{
    return uint(min(max(ceil(factor), Real(1)), Real(GRID_LARGEST)));
}

KNOTSPAN_TEMPLATE
FirstGrid firstGrid(WindowFigures KNOTSPAN_OF_REAL whole, Real tolerance)
{
    FirstGrid grid;
    grid.u = 1u;
    grid.v = 1u;
    grid.leastU = 1u;
    grid.leastV = 1u;
    grid.level = GRID_LEVELS;
    if (windowBound KNOTSPAN_OF_REAL(whole, Real(1), Real(1)) <= tolerance)
        return grid;
    // The fewest cells with (a / u^2 + 2 b / (u v) + c / v^2) / 8 = tolerance, in real numbers, u and v at least 1.
    Real w = max(whole.nearest, Real(1e-30f));
    Real a = (length(whole.a) + whole.spread.x) / w;
    Real b = (length(whole.b) + whole.spread.y) / w;
    Real c = (length(whole.c) + whole.spread.z) / w;
    Real e = Real(8) * tolerance;
    Real cells = Real(2) * (sqrt(a) * sqrt(c) + b) / e;
    Real aspect = sqrt(sqrt(max(a, Real(1e-30f)) / max(c, Real(1e-30f))));
    Real u = min(max(sqrt(cells) * aspect, Real(1)), Real(GRID_LARGEST));
    Real v = min(max(sqrt(cells) / aspect, Real(1)), Real(GRID_LARGEST));
    if (u == Real(1))
        v = max(v, (b + sqrt(b * b + max(e - a, Real(0)) * c)) / max(e - a, Real(1e-3f) * e));
    if (v == Real(1))
        u = max(u, (b + sqrt(b * b + max(e - c, Real(0)) * a)) / max(e - c, Real(1e-3f) * e));
    u = min(u, Real(GRID_LARGEST));
    v = min(v, Real(GRID_LARGEST));
    // The bound counts the three together, which is less; whole numbers are more. Fewer as long as it holds.
    Real found = sqrt(windowBound KNOTSPAN_OF_REAL(whole, Real(1) / u, Real(1) / v) / tolerance);
    if (found >= Real(0) && found < Real(1)) {
        u = max(u * found, Real(1));
        v = max(v * found, Real(1));
    }
    grid.u = wholeFactor KNOTSPAN_OF_REAL(u);
    grid.v = wholeFactor KNOTSPAN_OF_REAL(v);
    grid.leastU = min(max(uint(Real(0.75f) * Real(grid.u)), 1u), GRID_MOST_LEAST);
    grid.leastV = min(max(uint(Real(0.75f) * Real(grid.v)), 1u), GRID_MOST_LEAST);
    for (int attempt = 0; attempt < 10; ++attempt) {
        if (windowBound KNOTSPAN_OF_REAL(whole, Real(1) / Real(grid.u), Real(1) / Real(grid.v)) <= tolerance) {
            if (grid.u * grid.v == 2u)  // one cell is not enough, as far as windows of the whole tell
                return grid;
            grid.level = 0u;
            if (grid.leastU == 1u && grid.leastV == 1u) {
                if (grid.u > grid.v)
                    grid.leastU = 2u;
                else
                    grid.leastV = 2u;
            }
            return grid;
        }
        if (grid.u == GRID_LARGEST && grid.v == GRID_LARGEST)
            break;
        grid.u = min(grid.u + 1u + grid.u / 2u * (attempt > 1 ? 1u : 0u), GRID_LARGEST);
        grid.v = min(grid.v + 1u + grid.v / 2u * (attempt > 1 ? 1u : 0u), GRID_LARGEST);
    }
    // Only a part of it may show, or be near.
    grid.level = 0u;
    grid.leastU = max(grid.leastU / 2u, 1u);
    grid.leastV = max(grid.leastV / 2u, 1u);
    grid.u = GRID_NONE;
    grid.v = GRID_NONE;
    return grid;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
