// Curves brought to one degree and one set of knots, so that they can be rows of one net.
#pragma once

#include "model/geometry/nurbs_curve.h"

namespace knotspan {

// The same curves, clamped, over the domain of the first, of the highest degree among them and with the knots
// of all of them (degree elevation and knot insertion, so that no shape changes). A curve over another domain
// gets that one by an affine map; interior knots that differ by no more than its rounding become one, the
// first of them. At least one curve. Refuses, with a sentence, knots that come too close for that, and so
// many of them that there would be more than a million control points. The NURBS Book, 10.3.
[[nodiscard]] Result<std::vector<NurbsCurve>> compatibleCurves(const std::vector<NurbsCurve>& curves);

}  // namespace knotspan
