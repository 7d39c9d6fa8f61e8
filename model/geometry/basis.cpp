#include "model/geometry/basis.h"

#include "model/core/check.h"

namespace knotspan {

void raiseDegree(const KnotVector& knots, int span, double u, int d, BasisRow& row)
{
    double saved = 0;
    for (int r = 0; r < d; ++r) {
        const double left = knots[span + r + 1 - d];
        const double right = knots[span + r + 1];
        const double before = row[static_cast<size_t>(r)];
        // Divided first: a part of a span is at most 1, however short the span.
        row[static_cast<size_t>(r)] = saved + (right - u) / (right - left) * before;
        saved = (u - left) / (right - left) * before;
    }
    row[static_cast<size_t>(d)] = saved;
}

BasisOfDegrees basisOfDegrees(const KnotVector& knots, int span, double u)
{
    const int p = knots.degree();
    check(span >= p && span < knots.controlPointCount() && knots[span] < knots[span + 1],
          "basis functions are asked for on a span with a length");
    BasisOfDegrees result{};
    BasisRow row{};
    row[0] = 1;
    for (int d = 0; d <= p; ++d) {
        if (d > 0)
            raiseDegree(knots, span, u, d, row);
        if (p - d < 3)
            result[static_cast<size_t>(p - d)] = row;
    }
    return result;
}

}  // namespace knotspan
