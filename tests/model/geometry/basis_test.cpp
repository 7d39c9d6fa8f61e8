#include <gtest/gtest.h>

#include "model/geometry/basis.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

TEST(Basis, SumsToOneAndItsDerivativesToZero)
{
    std::mt19937 random(1);
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree)
        for (const bool clamped : {true, false}) {
            const KnotVector knots = testing::randomKnots(random, degree, 5, 100, clamped);
            for (const int span : knots.spans())
                for (const double part : {0.0, 0.3, 0.71, 1.0}) {
                    const double length = knots[span + 1] - knots[span];
                    const auto basis = basisDerivatives(knots, span, knots[span] + part * length);
                    double sums[3] = {0, 0, 0};
                    double sizes[3] = {0, 0, 0};
                    for (size_t order = 0; order < 3; ++order)
                        for (const double value : basis[order]) {
                            sums[order] += value;
                            sizes[order] += std::abs(value);
                        }
                    EXPECT_NEAR(sums[0], 1, 1e-14);
                    EXPECT_NEAR(sums[1], 0, 1e-14 * sizes[1]);
                    EXPECT_NEAR(sums[2], 0, 1e-14 * sizes[2]);
                    for (size_t k = 0; k <= static_cast<size_t>(degree); ++k)
                        EXPECT_GE(basis[0][k], -1e-15);
                }
        }
}

TEST(Basis, AgreesWithTheValuesPrintedInTheNurbsBook)
{
    // Example 2.3: U = {0,0,0,1,2,3,4,4,5,5,5}, u = 5/2, p = 2.
    const auto knots = *KnotVector::create(2, {0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5});
    const auto basis = basisDerivatives(knots, 4, 2.5);
    EXPECT_DOUBLE_EQ(basis[0][0], 1.0 / 8);
    EXPECT_DOUBLE_EQ(basis[0][1], 6.0 / 8);
    EXPECT_DOUBLE_EQ(basis[0][2], 1.0 / 8);
    // Example 2.4: first and second derivatives at the same place.
    EXPECT_DOUBLE_EQ(basis[1][0], -0.5);
    EXPECT_DOUBLE_EQ(basis[1][1], 0);
    EXPECT_DOUBLE_EQ(basis[1][2], 0.5);
    EXPECT_DOUBLE_EQ(basis[2][0], 1);
    EXPECT_DOUBLE_EQ(basis[2][1], -2);
    EXPECT_DOUBLE_EQ(basis[2][2], 1);
}

TEST(Basis, HasNoSecondDerivativeAtDegreeOne)
{
    const auto basis = basisDerivatives(KnotVector::clampedUniform(1, 2), 1, 0.25);
    EXPECT_DOUBLE_EQ(basis[0][0], 0.5);
    EXPECT_DOUBLE_EQ(basis[1][1], 2);
    EXPECT_EQ(basis[2][0], 0);
    EXPECT_EQ(basis[2][1], 0);
}

}  // namespace
}  // namespace knotspan
