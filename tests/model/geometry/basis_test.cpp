#include <algorithm>

#include <gtest/gtest.h>

#include "model/geometry/basis.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

TEST(Basis, SumsToOneInEveryDegreeAndIsNowhereNegative)
{
    std::mt19937 random(1);
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree)
        for (const bool clamped : {true, false}) {
            const KnotVector knots = testing::randomKnots(random, degree, 5, 100, clamped);
            for (const int span : knots.spans())
                for (const double part : {0.0, 0.3, 0.71, 1.0}) {
                    const double length = knots[span + 1] - knots[span];
                    const auto basis = basisOfDegrees(knots, span, knots[span] + part * length);
                    for (size_t lower = 0; lower <= static_cast<size_t>(std::min(degree, 2)); ++lower) {
                        double sum = 0;
                        for (const double value : basis[lower]) {
                            sum += value;
                            EXPECT_GE(value, -1e-15);
                        }
                        EXPECT_NEAR(sum, 1, 1e-14);
                    }
                }
        }
}

TEST(Basis, AgreesWithTheValuesPrintedInTheNurbsBook)
{
    // Example 2.3: U = {0,0,0,1,2,3,4,4,5,5,5}, u = 5/2, p = 2.
    const auto knots = *KnotVector::create(2, {0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5});
    const auto basis = basisOfDegrees(knots, 4, 2.5);
    EXPECT_DOUBLE_EQ(basis[0][0], 1.0 / 8);
    EXPECT_DOUBLE_EQ(basis[0][1], 6.0 / 8);
    EXPECT_DOUBLE_EQ(basis[0][2], 1.0 / 8);
    EXPECT_DOUBLE_EQ(basis[1][0], 1.0 / 2);
    EXPECT_DOUBLE_EQ(basis[1][1], 1.0 / 2);
    EXPECT_DOUBLE_EQ(basis[2][0], 1);
}

TEST(Basis, HasNoFunctionsOfDegreesBelowZero)
{
    const auto basis = basisOfDegrees(KnotVector::clampedUniform(1, 2), 1, 0.25);
    EXPECT_DOUBLE_EQ(basis[0][0], 0.5);
    EXPECT_DOUBLE_EQ(basis[1][0], 1);
    for (const double value : basis[2])
        EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace knotspan
