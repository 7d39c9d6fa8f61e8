#include "model/analysis/curvature.h"

#include <cmath>

#include <gtest/gtest.h>

#include "model/geometry/primitives.h"

namespace knotspan {
namespace {

TEST(Curvature, OfASphereIsOneOverItsRadiusAwayFromTheNormal)
{
    const NurbsSurface ball = sphere({0, 0, 0}, 4);
    for (const double v : {0.3, 1.0, 2.2, 3.7}) {
        const auto found = curvature(evaluate(ball, 1.3, v));
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->gauss, 1.0 / 16, 1e-13);
        EXPECT_NEAR(found->mean, -0.25, 1e-13);
        EXPECT_NEAR(found->largest, -0.25, 1e-6);
        EXPECT_NEAR(found->smallest, -0.25, 1e-6);
    }
}

TEST(Curvature, OfATorusIsPositiveOutsideAndNegativeInside)
{
    const NurbsSurface ring = torus({0, 0, 0}, 3, 1);
    const auto outside = curvature(evaluate(ring, 0.7, 0));
    const auto inside = curvature(evaluate(ring, 0.7, 4));
    ASSERT_TRUE(outside && inside);
    EXPECT_NEAR(outside->gauss, 1.0 / 4, 1e-13);
    EXPECT_NEAR(outside->smallest, -1, 1e-13);
    EXPECT_NEAR(outside->largest, -1.0 / 4, 1e-13);
    EXPECT_NEAR(inside->gauss, -1.0 / 2, 1e-13);
    EXPECT_NEAR(inside->largest, 1.0 / 2, 1e-13);
}

TEST(Curvature, IsNothingAtAPole)
{
    EXPECT_FALSE(curvature(evaluate(sphere({0, 0, 0}, 4), 1.3, 0)));
}

}  // namespace
}  // namespace knotspan
