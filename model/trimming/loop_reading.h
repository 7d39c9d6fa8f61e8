// Trim loops as files give them, made into closed chains of Bézier arcs, or refused; either way what was
// wrong is said.
//
// A point of the surface is inside where a way to it from the corner (start, start) of the domain crosses the
// chains an odd number of times, or an even number if `startsInside`. So loops may lie in each other, touch,
// or run the wrong way round.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/geometry/nurbs_surface.h"
#include "model/trimming/curve_cutting.h"

namespace knotspan {

constexpr std::uint32_t kNoCurve = 0xffffffffU;  // a line that closes a gap

struct LoopArc {
    TrimArc arc;
    std::uint32_t loop = 0;  // of the object's
    std::uint32_t curve = 0;
};
using LoopChain =
    std::vector<LoopArc>;  // each arc starts where the one before ends, the first where the last does

enum class LoopTrouble {
    empty,            // no curves: left out
    open,             // refused
    gaps,             // closed by lines
    enclosesNothing,  // kept
    wrongWay,         // kept: even-odd does not ask
    beyond,           // cut off at the domain
    acrossSeam,       // goes on at the other side: nothing wrong
    twice,            // the same loop is there already: the two cancel each other
    holeAround,       // an outline: what lies between them is inside
    holeOutside,      // of all outlines: what it encloses is inside
};
struct LoopFinding {
    std::uint32_t loop = 0;  // of the object's
    LoopTrouble trouble = LoopTrouble::open;
    double share = 0;  // of the domain: how wide, how far; 0 where that means nothing
};
[[nodiscard]] std::string sentenceOf(const LoopFinding& finding);
// A share of the domain in words: "15 % of the surface", "1.5 times the surface's size".
[[nodiscard]] std::string spoken(double share);

struct LoopReading {
    std::vector<LoopChain> chains;
    bool startsInside = false;
    bool refused = false;  // one of the loops is none: the surface counts as untrimmed
    std::vector<LoopFinding> findings;
};

// Gaps below 1/200 of the domain are bridged by a line. On a closed surface a loop may run around it, from
// one side of the seam to the other, or across the seam: then it counts again a period away.
[[nodiscard]] LoopReading readLoops(const std::vector<TrimLoop>& loops, const NurbsSurface& surface);

}  // namespace knotspan
