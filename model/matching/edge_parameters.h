// When parameters and parts of edges count as the same.
#pragma once

#include "model/friends/edge_part.h"

namespace knotspan {

inline constexpr double kSameKnot = 1e-9;  // of the domain's length

// A side's own parameter: u along v = start and v = end, v along the others.
[[nodiscard]] const KnotVector& knotsAlong(const NurbsSurface& surface, Side side);

// The part up to an end of its side where it leaves out no more of it than a piece no longer than `gap`, in
// model space: that is what corners leave which do not quite meet.
[[nodiscard]] EdgePart upToNearEnds(const PlacedSurface& placed, EdgePart part, double gap);

[[nodiscard]] bool isWholeSide(const NurbsSurface& surface, const EdgePart& part);

}  // namespace knotspan
