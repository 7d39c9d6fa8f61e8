// Basis functions by their definition, in any number type: the reference for the evaluators' own texts.
#pragma once

#include <vector>

#include "model/geometry/knot_vector.h"

namespace knotspan::testing {

// N_{i-p,p} .. N_{i,p} on span i as a polynomial of u, whatever u is, and their first and second derivatives. The NURBS Book,
// eqs. 2.5, 2.7 and 2.9; functions and fractions of empty spans are zero.
template <class Number>
struct ExactBasis {
    std::vector<Number> value;
    std::vector<Number> slope;
    std::vector<Number> bend;
};

template <class Number>
ExactBasis<Number> exactBasis(const KnotVector& knots, int span, const Number& u)
{
    const int p = knots.degree();
    const auto knot = [&](int k) { return Number(knots[k]); };
    const auto fraction = [](const Number& above, const Number& below) {
        return below == 0 ? Number(0) : Number(above / below);
    };
    // row[k] is N_{i-p+k,d}; the one above the last is zero.
    std::vector<Number> row(static_cast<size_t>(p) + 2, Number(0));
    std::vector<Number> lower(row.size(), Number(0));
    std::vector<Number> lowest;
    row[static_cast<size_t>(p)] = Number(1);
    for (int d = 1; d <= p; ++d) {
        lowest = lower;
        lower = row;
        for (int k = p - d; k <= p; ++k) {
            const int j = span - p + k;
            const auto at = static_cast<size_t>(k);
            row[at] = fraction(u - knot(j), knot(j + d) - knot(j)) * lower[at];
            if (k < p)
                row[at] += fraction(knot(j + d + 1) - u, knot(j + d + 1) - knot(j + 1)) * lower[at + 1];
        }
    }
    const auto lowerSlope = [&](int k) {  // of N_{i-p+k,p-1}
        const int j = span - p + k;
        const auto at = static_cast<size_t>(k);
        Number slope = fraction(lowest[at], knot(j + p - 1) - knot(j));
        slope -= fraction(lowest[at + 1], knot(j + p) - knot(j + 1));
        return Number(Number(p - 1) * slope);
    };
    ExactBasis<Number> result;
    for (int k = 0; k <= p; ++k) {
        const int j = span - p + k;
        const auto at = static_cast<size_t>(k);
        Number slope = fraction(lower[at], knot(j + p) - knot(j));
        if (k < p)
            slope -= fraction(lower[at + 1], knot(j + p + 1) - knot(j + 1));
        Number bend = fraction(lowerSlope(k), knot(j + p) - knot(j));
        if (k < p)
            bend -= fraction(lowerSlope(k + 1), knot(j + p + 1) - knot(j + 1));
        result.value.push_back(row[at]);
        result.slope.push_back(Number(p) * slope);
        result.bend.push_back(Number(p) * bend);
    }
    return result;
}

}  // namespace knotspan::testing
