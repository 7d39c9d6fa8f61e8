// The reference for B-spline basis functions: double, written for clarity, checked against multiple
// precision.
#pragma once

#include <array>

#include "model/geometry/knot_vector.h"

namespace knotspan {

// Row k holds the k-th derivatives of N_{i-p,p} .. N_{i,p}, the only ones that are not zero on span i.
using BasisRow = std::array<double, kMaxDegree + 1>;
using BasisDerivatives = std::array<BasisRow, 3>;

// Values, first and second derivatives at u on the span `span` (U_span < U_{span+1}). Only columns 0 ..
// degree are set, the others are 0. The NURBS Book, A2.3, with differences of knots only.
[[nodiscard]] BasisDerivatives basisDerivatives(const KnotVector& knots, int span, double u);

}  // namespace knotspan
