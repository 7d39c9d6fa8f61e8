// Splines through rows of numbers: what is interpolated across the curves of a loft.
#pragma once

#include <optional>

#include "model/geometry/knot_vector.h"

namespace knotspan {

using NumberRow = std::vector<double>;

// Control row k goes with the k-th basis function of `knots`. A number that all given rows share, these have
// too, to the bit.
struct RowSpline {
    KnotVector knots;
    std::vector<NumberRow> rows;
};

// Clamped, of degree min(3, n - 1), through row k at parameter k: n >= 2 rows of one length and n increasing
// parameters. Knots are means of parameters. The first and the last row are kept to the bit. Nothing where
// the parameters are so uneven that there is no solution in double. The NURBS Book, A9.1.
[[nodiscard]] std::optional<RowSpline> splineThrough(const std::vector<double>& parameters,
                                                     const std::vector<NumberRow>& rows);

// Cubic and periodic, not clamped, with a knot at each parameter: through row k at parameter k, and through
// the first again at the last parameter, with continuous second derivatives everywhere. n >= 3 rows, n + 1
// parameters, which bound the domain.
[[nodiscard]] std::optional<RowSpline> periodicSplineThrough(const std::vector<double>& parameters,
                                                             const std::vector<NumberRow>& rows);

}  // namespace knotspan
