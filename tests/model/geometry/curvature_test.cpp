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
        EXPECT_NEAR(found->largest, -0.25, 1e-14);
        EXPECT_NEAR(found->smallest, -0.25, 1e-14);
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

TEST(Curvature, OfACylinderIsThatOfItsCircleAndNone)
{
    const NurbsSurface ring = torus({0, 0, 0}, 3, 1);
    std::vector<ControlPoint> points;
    for (int i = 0; i < ring.countU(); ++i)
        for (const double z : {0.0, 7.0}) {
            const ControlPoint& on = ring.controlPoint(i, 0);
            points.push_back({{on.position.x, on.position.y, z}, on.weight});
        }
    const auto tube = NurbsSurface::create(ring.knotsU(), KnotVector::clampedUniform(1, 1), points).value();
    for (const double u : {0.0, 0.6, 3.5, 8.0}) {
        const auto found = curvature(evaluate(tube, u, 0.3));
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->smallest, -1.0 / 4, 1e-14);
        EXPECT_NEAR(found->largest, 0, 1e-14);
        EXPECT_NEAR(found->gauss, 0, 1e-14);
        EXPECT_NEAR(found->mean, -1.0 / 8, 1e-14);
    }
}

TEST(Curvature, IsNothingAtAPole)
{
    EXPECT_FALSE(curvature(evaluate(sphere({0, 0, 0}, 4), 1.3, 0)));
}

}  // namespace
}  // namespace knotspan
