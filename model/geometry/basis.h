// The reference for B-spline basis functions: double, written for clarity, checked against multiple
// precision.
#pragma once

#include <array>

#include "model/geometry/knot_vector.h"

namespace knotspan {

using BasisRow = std::array<double, kMaxDegree + 1>;

// Row k holds N_{i-p+k,p-k} .. N_{i,p-k}, the functions of degree p - k that are not zero on span i: those by
// which the control points of a k-th derivative count. Rows of degrees below 0 are 0.
using BasisOfDegrees = std::array<BasisRow, 3>;

// At u on the span `span` (U_span < U_{span+1}). Nothing cancels: each value is right to a few units of its
// last place. The NURBS Book, A2.2, with differences of knots only.
[[nodiscard]] BasisOfDegrees basisOfDegrees(const KnotVector& knots, int span, double u);

// One step of the recursion that makes them: from N_{i-d+1,d-1} .. N_{i,d-1} to N_{i-d,d} .. N_{i,d}, in
// place. With an argument of its own at each step it gives the blossom.
void raiseDegree(const KnotVector& knots, int span, double u, int d, BasisRow& row);

}  // namespace knotspan
