// The tables that the evaluators of shaders/shared read for a span, made in any number type: in a wider
// one than they are kept in for use, in exact fractions for tests. All are normalised to the span's length;
// where each number stands is said in the evaluator's own file, shaders/shared/NAME_basis.glsl.
#pragma once

#include <algorithm>
#include <vector>

#include "model/geometry/knot_vector.h"

namespace knotspan::evaluator_tables {

// L_1 .. L_p, R_1 .. R_p: how far the knots lie before and behind the span, in spans. Where a neighbour is
// more than `most` spans away its share is less than the number type can tell from nothing.
template <class Number>
std::vector<Number> differences(const KnotVector& knots, int span, const Number& most)
{
    std::vector<Number> result;
    const Number start(knots[span]);
    const Number end(knots[span + 1]);
    const Number length = end - start;
    const auto append = [&](const Number& difference) {
        const Number normalised = difference / length;
        result.push_back(normalised < most ? normalised : most);
    };
    for (int j = 1; j <= knots.degree(); ++j)
        append(start - Number(knots[span + 1 - j]));
    for (int j = 1; j <= knots.degree(); ++j)
        append(Number(knots[span + j]) - end);
    return result;
}

template <class Number>
std::vector<Number> triangular(int, const std::vector<Number>& differences)
{
    return differences;
}

template <class Number>
std::vector<Number> stair(int degree, const std::vector<Number>& differences)
{
    std::vector<Number> table = differences;
    for (int a = 1; a <= degree; ++a)
        for (int b = 1; a + b <= degree + 1; ++b) {
            const Number denominator = Number(1) + differences[static_cast<size_t>(a - 1)] +
                                       differences[static_cast<size_t>(degree + b - 1)];
            table.push_back(Number(1) / denominator);
        }
    return table;
}

// Polynomials on the span, by their coefficients, and their products with a linear factor that is `atStart`
// at t = 0, `atEnd` at t = 1 and rises by `slope`.
template <class Number>
struct Linear {
    Number atStart;
    Number atEnd;
    Number slope;
};

// Of t^m.
struct PowerForm {
    template <class Number>
    static std::vector<Number> product(const std::vector<Number>& f, const Linear<Number>& by)
    {
        std::vector<Number> result(f.size() + 1, Number(0));
        for (size_t m = 0; m < f.size(); ++m) {
            result[m] += by.atStart * f[m];
            result[m + 1] += by.slope * f[m];
        }
        return result;
    }
};

// Of t^m (1 - t)^(d-m). Here a linear factor is atStart (1 - t) + atEnd t, and where both are positive
// nothing cancels.
struct BernsteinForm {
    template <class Number>
    static std::vector<Number> product(const std::vector<Number>& f, const Linear<Number>& by)
    {
        std::vector<Number> result(f.size() + 1, Number(0));
        for (size_t m = 0; m < f.size(); ++m) {
            result[m] += by.atStart * f[m];
            result[m + 1] += by.atEnd * f[m];
        }
        return result;
    }
};

// The functions N_{i-p,p} .. N_{i,p} as polynomials, and the shares N_{i-p+1+k,p-1} / (1 + L + R), k = 0 .. p
// - 1. The NURBS Book, A2.2, with polynomials in place of values.
template <class Number>
struct Polynomials {
    std::vector<std::vector<Number>> functions;
    std::vector<std::vector<Number>> shares;
};

template <class Form, class Number>
Polynomials<Number> polynomials(int degree, const std::vector<Number>& differences)
{
    const Number one(1);
    Polynomials<Number> result;
    result.functions = {{one}};
    for (int d = 1; d <= degree; ++d) {
        result.shares.clear();
        std::vector<Number> carried(static_cast<size_t>(d) + 1, Number(0));
        for (int r = 0; r < d; ++r) {
            const Number& left = differences[static_cast<size_t>(d - r - 1)];
            const Number& right = differences[static_cast<size_t>(degree + r)];
            std::vector<Number>& function = result.functions[static_cast<size_t>(r)];
            const Number denominator = one + left + right;
            for (Number& coefficient : function)
                coefficient /= denominator;
            result.shares.push_back(function);
            const auto falling = Form::template product<Number>(function, {right + one, right, -one});
            const auto rising = Form::template product<Number>(function, {left, left + one, one});
            function = carried;
            for (size_t m = 0; m < function.size(); ++m)
                function[m] += falling[m];
            carried = rising;
        }
        result.functions.push_back(carried);
    }
    return result;
}

template <class Number>
std::vector<Number> power(int degree, const std::vector<Number>& differences)
{
    std::vector<Number> table;
    for (const auto& function : polynomials<PowerForm>(degree, differences).functions)
        table.insert(table.end(), function.begin(), function.end());
    return table;
}

template <class Number>
std::vector<Number> bernstein(int degree, const std::vector<Number>& differences)
{
    std::vector<Number> table;
    const auto made = polynomials<BernsteinForm>(degree, differences);
    for (const auto& function : made.functions)
        table.insert(table.end(), function.begin(), function.end());
    for (const auto& share : made.shares)
        for (const Number& coefficient : share)
            table.push_back(Number(degree) * coefficient);
    return table;
}

}  // namespace knotspan::evaluator_tables
