#include "model/geometry/basis.h"

#include "model/core/check.h"

namespace knotspan {

namespace {

// From N_{i-d+1,d-1} .. N_{i,d-1} to N_{i-d,d} .. N_{i,d}, in place. The NURBS Book, A2.2.
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

// From functions of degree d - 1 to the derivatives of those of degree d; the same rule takes derivatives of
// degree d - 1 to the next derivatives of degree d. The NURBS Book, eq. 2.9.
BasisRow differentiate(const KnotVector& knots, int span, int d, const BasisRow& lower)
{
    BasisRow result{};
    for (int r = 0; r <= d; ++r) {
        const int j = span - d + r;
        double value = 0;
        if (r > 0)
            value += lower[static_cast<size_t>(r) - 1] / (knots[j + d] - knots[j]);
        if (r < d)
            value -= lower[static_cast<size_t>(r)] / (knots[j + d + 1] - knots[j + 1]);
        result[static_cast<size_t>(r)] = d * value;
    }
    return result;
}

}  // namespace

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

BasisDerivatives basisDerivatives(const KnotVector& knots, int span, double u)
{
    const int p = knots.degree();
    const BasisOfDegrees basis = basisOfDegrees(knots, span, u);
    BasisDerivatives result{basis[0], differentiate(knots, span, p, basis[1]), {}};
    if (p >= 2)
        result[2] = differentiate(knots, span, p, differentiate(knots, span, p - 1, basis[2]));
    return result;
}

}  // namespace knotspan
