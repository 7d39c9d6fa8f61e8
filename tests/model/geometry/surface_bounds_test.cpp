#include "model/analysis/surface_bounds.h"

#include <chrono>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "tests/model/trimming/loop_samples.h"
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

// A bicubic sheet of points x, y at unit distance, with heights by a function of them.
NurbsSurface sheet(int spans, const std::function<double(int, int)>& height)
{
    const KnotVector knots = KnotVector::clampedUniform(3, spans);
    std::vector<ControlPoint> points;
    for (int i = 0; i < spans + 3; ++i)
        for (int j = 0; j < spans + 3; ++j)
            points.push_back({{i, j, height(i, j)}, 1.0});
    return *NurbsSurface::create(knots, knots, points);
}

TEST(SurfaceBounds, OfManyKsQuadsAreTheSameAsOfAllTheirPoints)
{
    std::mt19937 random(5);
    const NurbsSurface surface = sheet(40, [&](int, int) { return randomBetween(random, -1, 1); });
    const Box box = surfaceBounds(surface, Mat4(1.0));
    Box dense;
    constexpr int kPoints = 40 * 16;
    for (int i = 0; i <= kPoints; ++i)
        for (int j = 0; j <= kPoints; ++j)
            dense.add(evaluate(surface, double(i) / kPoints, double(j) / kPoints).position);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LE(box.low[axis], dense.low[axis] + 1e-9);
        EXPECT_GE(box.high[axis], dense.high[axis] - 1e-9);
    }
    EXPECT_LT(box.high.z - dense.high.z, 0.01);  // the dense points come that near
    EXPECT_LT(dense.low.z - box.low.z, 0.01);
}

TEST(SurfaceBounds, OfSpansOfVeryDifferentLengthsAreFoundAtOnce)
{
    // Both spans have the highest control point, and the top is in the long one.
    const KnotVector uneven = *KnotVector::create(3, {0, 0, 0, 0, 1e-9, 1, 1, 1, 1});
    const KnotVector even = KnotVector::clampedUniform(1, 1);
    std::vector<ControlPoint> points;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 2; ++j)
            points.push_back({{i, j, i == 3 ? 1.0 : 0.0}, 1.0});
    const NurbsSurface surface = *NurbsSurface::create(uneven, even, points);
    const Box box = surfaceBounds(surface, Mat4(1.0));
    EXPECT_NEAR(box.high.z, 4.0 / 9, 1e-8);  // of 3 t^2 (1 - t), at t = 2/3
    EXPECT_NEAR(box.low.z, 0, 1e-12);
}

TEST(SurfaceBounds, OfAHundredThousandKsQuadsTakeLessThanASecond)
{
    constexpr int kSpans = 314;
    const auto wave = [](int i, int j) { return 20 * std::sin(0.03 * i) * std::cos(0.02 * j + 0.01 * i); };
    const auto ridge = [](int i, int j) { return -1e-3 * (i - j) * (i - j); };
    const auto flat = [](int i, int j) { return 0.25 * i - 0.5 * j; };
    const std::function<double(int, int)> heights[] = {wave, ridge, flat};
    for (const auto& height : heights) {
        const NurbsSurface surface = sheet(kSpans, height);
        const auto start = std::chrono::steady_clock::now();
        const Box box = surfaceBounds(surface, Mat4(1.0));
        const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
        EXPECT_LT(took.count(), 1);  // measured: 0.03
        EXPECT_NEAR(box.high.x, kSpans + 2, 1e-6);
    }
}

// A disc in a plane that stands aslant, and a ring: the outer circle counts.
TEST(SurfaceBounds, OfATrimmedPlaneAreThoseOfItsCircle)
{
    Mat4 aslant(1.0);
    aslant[0] = Vec4(std::sqrt(0.5), std::sqrt(0.5), 0, 0);
    aslant[1] = Vec4(-0.5, 0.5, std::sqrt(0.5), 0);
    const std::vector<TrimLoop> disc{{true, {circle({0.9, 11.1}, 0.7)}}};
    const std::vector<TrimLoop> ring{disc[0], {false, {circle({1, 11.2}, 0.3, false)}}};
    const Vec3 centre(aslant * Vec4(0.9, 11.1, 0, 1));
    // Along an axis a circle reaches as far as the axis leans towards its plane.
    const Vec3 reach = 0.7 * Vec3(std::sqrt(0.5 + 0.25), std::sqrt(0.5 + 0.25), std::sqrt(0.5));
    for (const auto& loops : {disc, ring})
        for (const auto& surface : {flatSurface(), flatSurface({-1, 3}, {10, 12})}) {
            const Box box = trimmedBounds(surface, loops, aslant);
            expectNear(box.low, centre - reach, 1e-9);
            expectNear(box.high, centre + reach, 1e-9);
        }
}

// The top of a cap is inside its circle, the rest of its box is the circle's.
TEST(SurfaceBounds, OfATrimmedBallHoldTheTopOfWhatIsLeft)
{
    const NurbsSurface ball = sphere(Vec3(0), 5.0);
    const Vec2 at(0.31 * ball.knotsU().domainEnd(), 0.63 * ball.knotsV().domainEnd());
    const Vec3 top = evaluate(ball, at.x, at.y).position;
    // Turned so that this place is the highest.
    const Vec3 up = top / 5.0;
    const Vec3 side = Vec3(-up.y, up.x, 0) / std::hypot(up.x, up.y);
    const Vec3 third(up.y * side.z - up.z * side.y, up.z * side.x - up.x * side.z,
                     up.x * side.y - up.y * side.x);
    Mat4 turn(1.0);
    for (int k = 0; k < 3; ++k)
        turn[k] = Vec4(side[k], third[k], up[k], 0);
    for (const double radius : {0.3, 0.02}) {
        const TrimCurve curve = circle(at, radius);
        const Box box = trimmedBounds(ball, {{true, {curve}}}, turn);
        EXPECT_NEAR(box.high.z, 5, 1e-8) << radius;
        Box outline;
        for (const int span : curve.knots().spans())
            for (int k = 0; k < 2000; ++k) {
                const double t = std::lerp(curve.knots()[span], curve.knots()[span + 1], k / 2000.0);
                const Vec2 place = curve.evaluate(t);
                outline.add(transformed(evaluate(ball, place.x, place.y).position, turn));
            }
        EXPECT_NEAR(box.low.z, outline.low.z, 1e-5 * radius);
        for (int axis = 0; axis < 2; ++axis) {
            EXPECT_NEAR(box.low[axis], outline.low[axis], 1e-5 * radius);
            EXPECT_NEAR(box.high[axis], outline.high[axis], 1e-5 * radius);
        }
    }
    const Box whole = surfaceBounds(ball, turn);
    EXPECT_EQ(trimmedBounds(ball, {}, turn).low, whole.low);
}

}  // namespace
}  // namespace knotspan::testing
