// The surface that fewer knots, or a lower degree, allow: nearest in the sense of least squares.
#pragma once

#include "model/geometry/knot_insertion.h"

namespace knotspan {

// With `knots` along a direction, clamped and over the same domain as before. The rows at both ends are kept;
// what the knots can represent exactly is returned but for rounding. Fitted are homogeneous points, at more
// places a span than either degree. Fails, with a sentence, where no such surface has weights above zero.
[[nodiscard]] Result<NurbsSurface> fittedTo(const NurbsSurface& surface, Direction direction,
                                            const KnotVector& knots);

}  // namespace knotspan
