#include "model/analysis/surface_bounds.h"

#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

void expectNear(const Vec3& a, const Vec3& b, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(a[axis], b[axis], tolerance) << "axis " << axis;
}

TEST(SurfaceBounds, OfASphereAreItsRadiusWhateverItsNet)
{
    Mat4 transform(1.0);  // turned, so that no control point lies where the surface ends
    transform[0] = Vec4(0.6, 0.8, 0, 0);
    transform[1] = Vec4(-0.8, 0.6, 0, 0);
    transform[3] = Vec4(100, 0, -7, 1);
    const Box box = surfaceBounds(sphere(Vec3(0), 5.0), transform);
    expectNear(box.low, {95, -5, -12}, 1e-8);
    expectNear(box.high, {105, 5, -2}, 1e-8);
}

TEST(SurfaceBounds, HoldThePointsOfASurfaceAndLieInsideItsNet)
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 10; ++trial) {
        const NurbsSurface surface =
            randomSurface(random, {.degreeU = 3, .degreeV = 2, .rational = true, .clamped = trial % 2 == 0});
        const Box box = surfaceBounds(surface, Mat4(1.0));
        const double slack = 1e-6 * surface.bounds().diagonal();
        for (int k = 0; k < 300; ++k) {
            const Vec3 point =
                evaluate(surface,
                         randomBetween(random, surface.knotsU().domainStart(), surface.knotsU().domainEnd()),
                         randomBetween(random, surface.knotsV().domainStart(), surface.knotsV().domainEnd()))
                    .position;
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(point[axis], box.low[axis] - slack);
                EXPECT_LE(point[axis], box.high[axis] + slack);
            }
        }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(box.low[axis], surface.bounds().low[axis] - slack);
            EXPECT_LE(box.high[axis], surface.bounds().high[axis] + slack);
        }
    }
}

}  // namespace
}  // namespace knotspan::testing
