// The search among a KSQuad's windows (grid_choice.glsl) for the grid of fewest cells: the same text for GLSL, where the
// stage has declared `windows`, and for C++.
#ifndef KNOTSPAN_GRID_SEARCH_GLSL
#define KNOTSPAN_GRID_SEARCH_GLSL

#include "first_grid.glsl"

#ifdef __cplusplus
#define KNOTSPAN_WINDOW(index) source.window(index)
namespace knotspan::gpu {
#else
#define KNOTSPAN_WINDOW(index) windows[index]
#endif

// The bound of a grid over the windows from `first` on.
KNOTSPAN_SOURCE_TEMPLATE
Real gridBound(KNOTSPAN_SOURCE uint first, uint u, uint v)
{
    Real largest = Real(0);
    for (uint k = 0u; k < GRID_LANES; ++k) {
        Real bound = windowBound KNOTSPAN_OF_REAL(KNOTSPAN_WINDOW(first + k), Real(1) / Real(u), Real(1) / Real(v));
        largest = bound <= largest ? largest : bound;  // also where it is no number
    }
    return largest;
}

// A grid as one number: fewer cells are less.
KNOTSPAN_INLINE uint gridKey(uint u, uint v) { return u == GRID_NONE ? GRID_NONE : u * v << 11u | u; }
KNOTSPAN_INLINE uint keyU(uint key) { return key == GRID_NONE ? GRID_LARGEST : key & 2047u; }
KNOTSPAN_INLINE uint keyV(uint key) { return key == GRID_NONE ? GRID_LARGEST : (key >> 11u) / (key & 2047u); }

// The best grid that lane `lane` of GRID_LANES finds, as a key: each tries other factors along u, and for each the
// least along v that holds. `windows` were made for first.leastU and first.leastV.
KNOTSPAN_SOURCE_TEMPLATE
uint bestOfLane(KNOTSPAN_SOURCE uint windowsFrom, FirstGrid first, uint lane, Real tolerance)
{
    uint most = first.u == GRID_NONE ? GRID_LARGEST * GRID_LARGEST : first.u * first.v;
    uint largestU = min(most / first.leastV, GRID_LARGEST);
    uint u = first.leastU + lane;
    if (largestU >= first.leastU + GRID_LANES)  // a little beside the best factor costs next to nothing
        u = uint(ceil(Real(first.leastU) *
                      pow(Real(largestU) / Real(first.leastU), Real(lane) / Real(GRID_LANES - 1u)) - Real(0.01f)));
    uint mostV = min(most / max(u, 1u), GRID_LARGEST);
    if (u > largestU || mostV < first.leastV)
        return GRID_NONE;
    // Between what fails and what holds; the bound stands here once, since software drivers compile it for seconds.
    uint low = first.leastV - 1u;
    uint high = mostV + 1u;
    uint v = mostV;
    while (low + 1u < high) {
        if (gridBound KNOTSPAN_OF_REAL(KNOTSPAN_PASS_SOURCE windowsFrom, u, v) <= tolerance)
            high = v;
        else
            low = v;
        v = (low + high) / 2u;
    }
    if (high > mostV)
        return GRID_NONE;
    return gridKey(u, high);
}

// After a search: what the next level starts from, with more windows than cells' cost is worth otherwise; level
// GRID_LEVELS where the grid is good enough.
KNOTSPAN_INLINE FirstGrid nextLevel(FirstGrid first, uint key)
{
    FirstGrid next = first;
    ++next.level;
    bool enough = key != GRID_NONE && (key >> 11u) <= GRID_FEW_CELLS << 2u * first.level;
    if (enough || next.level == GRID_LEVELS) {
        next.level = GRID_LEVELS;
        return next;
    }
    if (key == GRID_NONE)
        return next;
    uint most = GRID_MOST_LEAST << next.level;
    next.u = keyU(key);
    next.v = keyV(key);
    next.leastU = min(max(next.u - (next.u + 5u) / 6u, 1u), most);
    next.leastV = min(max(next.v - (next.v + 5u) / 6u, 1u), most);
    return next;
}

#ifdef __cplusplus
}  // namespace knotspan::gpu
#endif
#endif
