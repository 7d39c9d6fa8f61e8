// What people do to a surface's net: more or fewer knots, another degree, a net rebuilt, a surface cut. Each
// says how far the surface moves, so that it can be shown before it is applied.
//
// Parameters stay what they are, so trim loops stay right.
#pragma once

#include <utility>

#include "model/geometry/knot_insertion.h"
#include "model/refining/deviation.h"

namespace knotspan {

struct Refinement {
    NurbsSurface surface;
    Deviation deviation;  // from the surface before
};

// The knot `value` once more, the shape unchanged. Refuses, with a sentence, what is not inside the domain or
// stands there as often as the degree already.
[[nodiscard]] Result<Refinement> insertKnot(const NurbsSurface& surface, Direction direction, double value);

// The interior knot nearest to `value` once less. Refuses where there is none, and, with the deviation that
// it would cost, where that is more than `tolerance`.
[[nodiscard]] Result<Refinement> removeKnot(const NurbsSurface& surface, Direction direction, double value,
                                            double tolerance);

// One degree more, the shape unchanged; refuses above kMaxDegree.
[[nodiscard]] Result<Refinement> raiseDegree(const NurbsSurface& surface, Direction direction);

// One degree less: knots that stand there once go, as a lower degree cannot be as smooth across them.
// Refuses degree 1, and what deviates by more than `tolerance`.
[[nodiscard]] Result<Refinement> lowerDegree(const NurbsSurface& surface, Direction direction,
                                             double tolerance);

struct NetShape {
    int countU = 0;  // control points
    int countV = 0;
    int degreeU = 3;
    int degreeV = 3;
};
// As near as a net of that shape with evenly spaced knots comes; its borders are fitted, corners kept.
// Refuses counts that are not above their degrees.
[[nodiscard]] Result<Refinement> rebuild(const NurbsSurface& surface, const NetShape& shape);

// The parts before and after a parameter inside the domain; both keep their parameters.
[[nodiscard]] Result<std::pair<NurbsSurface, NurbsSurface>> splitAt(const NurbsSurface& surface,
                                                                    Direction direction, double value);

}  // namespace knotspan
