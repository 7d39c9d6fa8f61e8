// The second derivatives of a rational patch as polynomials over w^3.
#pragma once

#include <array>

#include "model/geometry/bezier_conversion.h"

namespace knotspan {

// S = A / w: the Bernstein coefficients of w^3 S_uu, of degree (3p - 2, 3q), of w^3 S_uv, (3p - 1, 3q - 1),
// and of w^3 S_vv, (3p, 3q - 2), each stored as a BezierNet's points, with 0 in w. p, q > 0.
[[nodiscard]] std::array<std::vector<Vec4>, 3> secondDerivativesOfSurface(const BezierNet& net);

}  // namespace knotspan
