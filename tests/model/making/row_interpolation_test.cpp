// Splines through rows of numbers.
#include "model/making/row_interpolation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/geometry/basis.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

// The spline's first number at v, or that of a derivative (0 .. 2).
double valueAt(const RowSpline& spline, double v, int derivative = 0)
{
    const KnotVector& knots = spline.knots;
    const int p = knots.degree();
    const int span = knots.findSpan(v);
    std::vector<double> net;
    for (int k = span - p; k <= span; ++k)
        net.push_back(spline.rows[static_cast<size_t>(k)][0]);
    for (int d = 1; d <= derivative; ++d)  // The NURBS Book, 3.8
        for (int k = p; k >= d; --k) {
            const int knot = span - p + k;
            net[static_cast<size_t>(k)] = (p - d + 1) *
                                          (net[static_cast<size_t>(k)] - net[static_cast<size_t>(k - 1)]) /
                                          (knots[knot + p - d + 1] - knots[knot]);
        }
    const BasisRow basis = basisOfDegrees(knots, span, v)[static_cast<size_t>(derivative)];
    double sum = 0;
    for (int k = derivative; k <= p; ++k)
        sum += basis[static_cast<size_t>(k - derivative)] * net[static_cast<size_t>(k)];
    return sum;
}

// Uneven parameters make it swing far beyond the rows.
double largestOf(const RowSpline& spline)
{
    double largest = 1;
    for (const NumberRow& row : spline.rows)
        largest = std::max(largest, std::abs(row[0]));
    return largest;
}

std::vector<double> randomParameters(std::mt19937& random, size_t count)
{
    std::vector<double> parameters{-1};
    while (parameters.size() < count)
        parameters.push_back(parameters.back() + std::pow(10, randomBetween(random, -1.5, 1.5)));
    return parameters;
}

}  // namespace

TEST(RowInterpolation, GoesThroughEveryRow)
{
    std::mt19937 random(61);
    for (size_t n = 2; n < 40; ++n) {
        const std::vector<double> parameters = randomParameters(random, n);
        std::vector<NumberRow> rows;
        for (size_t k = 0; k < n; ++k)
            rows.push_back({randomBetween(random, -1, 1), 0.7});
        const auto spline = splineThrough(parameters, rows);
        ASSERT_TRUE(spline);
        EXPECT_EQ(spline->knots.degree(), std::min(3, static_cast<int>(n) - 1));
        EXPECT_EQ(spline->rows.size(), n);
        for (size_t k = 0; k < n; ++k)
            EXPECT_NEAR(valueAt(*spline, parameters[k]), rows[k][0], 1e-14 * largestOf(*spline));
        for (const NumberRow& row : spline->rows)
            EXPECT_EQ(row[1], 0.7);  // what does not change across stays so
    }
}

TEST(RowInterpolation, FindsTheCubicThatTheRowsLieOn)
{
    const auto cubic = [](double v) { return ((2 * v - 3) * v + 1) * v - 5; };
    std::vector<double> parameters{0, 0.3, 1, 1.2, 2, 3.5};
    std::vector<NumberRow> rows;
    for (const double v : parameters)
        rows.push_back({cubic(v)});
    const auto spline = splineThrough(parameters, rows);
    for (double v = 0; v < 3.5; v += 0.1)
        EXPECT_NEAR(valueAt(*spline, v), cubic(v), 1e-12);
}

TEST(RowInterpolation, RoundAndRoundIsSmoothEverywhere)
{
    std::mt19937 random(62);
    for (size_t n = 3; n < 30; ++n) {
        const std::vector<double> parameters = randomParameters(random, n + 1);
        std::vector<NumberRow> rows;
        for (size_t k = 0; k < n; ++k)
            rows.push_back({randomBetween(random, -1, 1)});
        const auto spline = periodicSplineThrough(parameters, rows);
        ASSERT_TRUE(spline) << n;
        for (size_t k = 0; k <= n; ++k)
            EXPECT_NEAR(valueAt(*spline, parameters[k]), rows[k % n][0], 1e-14 * largestOf(*spline));
        for (const int derivative : {0, 1, 2}) {
            const double start = valueAt(*spline, parameters.front(), derivative);
            const double end = valueAt(*spline, parameters.back(), derivative);
            EXPECT_NEAR(start, end, 1e-9 * (1 + std::abs(start))) << derivative;
        }
    }
}

}  // namespace knotspan::testing
