// An independent evaluation in 50 decimal digits: de Boor's algorithm on the homogeneous net, derivatives as
// B-splines of difference points. It shares no formula with the product's triangular tables.
#pragma once

#include <array>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "model/geometry/nurbs_surface.h"

namespace knotspan::testing {

using Real = boost::multiprecision::cpp_bin_float_50;
using RealVec3 = std::array<Real, 3>;

struct PrecisePoint {
    RealVec3 position, du, dv, duu, duv, dvv;
};

// At (u, v) inside the domain, interior knots belonging to the span on their right.
[[nodiscard]] PrecisePoint preciseEvaluation(const NurbsSurface& surface, double u, double v);

// By the polynomials of the KSQuad (spanU, spanV), also on its far borders.
[[nodiscard]] PrecisePoint preciseEvaluation(const NurbsSurface& surface, int spanU, const Real& u, int spanV,
                                             const Real& v);

// The parameter t in [0, 1] of the way along a span, without rounding.
[[nodiscard]] Real parameterOnSpan(const KnotVector& knots, int span, double t);

[[nodiscard]] RealVec3 cross(const RealVec3& a, const RealVec3& b);
[[nodiscard]] Real dot(const RealVec3& a, const RealVec3& b);
[[nodiscard]] Real length(const RealVec3& a);

}  // namespace knotspan::testing
