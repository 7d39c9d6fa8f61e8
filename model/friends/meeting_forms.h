// What two matched parts of edges say about how their surfaces meet, as polynomials along the edge in
// Bernstein form, so that figures at the ends are attained and figures over the part are bounded by the
// coefficients.
//
// A quotient of two polynomials whose denominator has coefficients above zero is a mean of the quotients of
// their coefficients: that is what all bounds rest on.
#pragma once

#include <optional>

#include "model/friends/bernstein_products.h"
#include "model/friends/edge_strip.h"

namespace knotspan {

// (x, y, z) / w is the way from one point to the one matched with it; w > 0.
[[nodiscard]] Form gapForm(const std::vector<Vec4>& a, const std::vector<Vec4>& b);
[[nodiscard]] double gapBound(const Form& form);  // no gap is larger
[[nodiscard]] double leastGap(const Form& form);  // nor smaller than this
// No point of b is further along b, to first order, from being nearest to the one matched with it; infinite
// where b may stand still or turn back.
[[nodiscard]] double slipBound(const std::vector<Vec4>& a, const std::vector<Vec4>& b);

// Which ends of a part are ends of the edge.
struct EdgeEnds {
    bool first = false;
    bool last = false;
};

// C' x (derivative into the surface) along an edge, to a positive factor: the normal. Where it vanishes at an
// end of the edge, as where that runs into a pole, a power of t or 1 - t is divided out, so that the limit
// stands there. Scaled coefficients, of which the largest figure is 1; none where it vanishes all along or at
// an end of the part that is none of the edge. `noise`: how far off coordinates may be by rounding.
[[nodiscard]] Vectors normalForm(const EdgeRows& rows, const EdgeEnds& ends, double noise);

// (x, y, z) = n_a x n_b, w = n_a . n_b, n_b turned so that surfaces that run on have equal normals: the
// tangent of the angle between them is |(x, y, z)| / w. The largest figures are 1 long.
[[nodiscard]] Form angleForm(const Vectors& a, const Vectors& b);
// Of any angle on the part, in radians; pi where the coefficients guarantee nothing.
[[nodiscard]] double angleBound(const Form& form);
// Nothing is attained, 0, where there is no normal but for rounding.
[[nodiscard]] double angleAt(const Vec4& figures);

// Normal curvatures across the edge, perpendicular to it, to the side of a's normal n: with |n|^2 = w, they
// are x / (z |n|) of a and y / (z |n|) of b, the latter to a factor of the cosine of the angle; z > 0, w > 0.
// Nothing where normals vanish and curvatures have no limit.
[[nodiscard]] std::optional<Form> curvatureForm(const EdgeRows& a, const EdgeRows& b, double noise);

}  // namespace knotspan
