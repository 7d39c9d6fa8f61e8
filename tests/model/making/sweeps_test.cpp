// Swept surfaces against the curve's own points, moved and turned.
#include "model/making/sweeps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/geometry/arcs.h"
#include "model/geometry/evaluation.h"
#include "tests/model/making/making_samples.h"

namespace knotspan::testing {

namespace {

constexpr double kPi = 3.14159265358979323846;

NurbsCurve anyCurve(std::mt19937& random, int round)
{
    return randomCurve(random, {1 + round % 5, 1 + round % 4, round % 2 == 1 ? 4.0 : 1.0, round % 7 != 3});
}

// Rodrigues' formula.
Vec3 turned(const Vec3& point, const RevolvingAxis& axis, double angle)
{
    const Vec3 a = glm::normalize(axis.direction);
    const Vec3 x = point - axis.point;
    return axis.point + std::cos(angle) * x + std::sin(angle) * glm::cross(a, x) +
           (1 - std::cos(angle)) * glm::dot(a, x) * a;
}

// How far round the axis a surface of revolution is at u. Seen in complex numbers, an arc of angle s is the
// square of the straight line from 1 to e^(is/2), made of length 1.
double angleAt(double u, double degrees)
{
    const double pieces = std::ceil(std::abs(degrees) / 45);
    const double step = degrees / pieces * kPi / 180;
    const double piece = std::min(std::floor(u), pieces - 1);
    const double t = u - piece;
    return piece * step + 2 * std::atan2(t * std::sin(step / 2), 1 - t + t * std::cos(step / 2));
}

}  // namespace

TEST(Extruding, MovesEveryPointOfTheCurve)
{
    std::mt19937 random(91);
    for (int round = 0; round < 100; ++round) {
        const NurbsCurve curve = anyCurve(random, round);
        const Vec3 vector = randomVector(random, 3);
        const auto surface = extruded(curve, vector);
        ASSERT_TRUE(surface) << surface.error().sentence();
        EXPECT_EQ(surface->knotsU(), curve.knots());
        EXPECT_EQ(isoCurve(*surface, Direction::V, 0).value(), curve);
        for (int k = 0; k < 50; ++k) {
            const double u = randomIn(random, curve.knots());
            const double v = randomBetween(random, 0, 1);
            EXPECT_LE(glm::distance(evaluate(*surface, u, v).position, evaluate(curve, u) + v * vector),
                      1e-14 * reachOf(surface->bounds()));
        }
    }
}

TEST(Extruding, ACircleUpwardsGivesACylinderWithItsNormalsOutwards)
{
    const auto surface = extruded(circleAt(0, 2), {0, 0, 3});
    for (double u = 0.1; u < 8; u += 0.3) {
        const Vec3 at = evaluate(*surface, u, 0.4).position;
        EXPECT_NEAR(std::hypot(at.x, at.y), 2, 1e-14);
        EXPECT_GT(glm::dot(evaluateNormal(*surface, u, 0.4).direction, Vec3(at.x, at.y, 0)), 1.999);
    }
}

TEST(Extruding, RefusesWhatSweepsNoArea)
{
    const NurbsCurve line = lineFrom({0, 0, 0}, {1, 2, 3});
    EXPECT_FALSE(extruded(line, Vec3(0)));
    EXPECT_FALSE(extruded(line, {0, std::nan(""), 0}));
    EXPECT_FALSE(extruded(line, {std::numeric_limits<double>::infinity(), 0, 0}));
    EXPECT_FALSE(extruded(line, {-2, -4, -6}));
    EXPECT_FALSE(extruded(lineFrom(Vec3(1), Vec3(1)), {1, 0, 0}));
    EXPECT_FALSE(extruded(lineFrom(Vec3(1e9), Vec3(2e9)), {1e-9, 0, 0}));
    EXPECT_EQ(extruded(line, Vec3(0)).error().sentence(),
              "The vector has no length. Give one that is not zero.");
}

TEST(Revolving, TurnsEveryPointOfTheCurve)
{
    std::mt19937 random(92);
    const double angles[] = {360, -360, 90, 45, 1, -200, 359.999, 123.456, 315};
    for (int round = 0; round < 90; ++round) {
        const NurbsCurve curve = anyCurve(random, round);
        const RevolvingAxis axis{randomVector(random, 3), randomVector(random, 1)};
        const double degrees = angles[round % 9];
        const auto surface = revolved(curve, axis, degrees);
        ASSERT_TRUE(surface) << surface.error().sentence();
        EXPECT_EQ(isoCurve(*surface, Direction::U, 0).value(), curve);
        const double size = reachOf(surface->bounds()) + glm::length(axis.point);
        for (int k = 0; k < 50; ++k) {
            const double u = randomIn(random, surface->knotsU());
            const double v = randomIn(random, surface->knotsV());
            const Vec3 expected = turned(evaluate(curve, v), axis, angleAt(u, degrees));
            EXPECT_LE(glm::distance(evaluate(*surface, u, v).position, expected), 1e-14 * size) << degrees;
        }
        const Vec3 end = evaluate(*surface, surface->knotsU().domainEnd(), 0.3).position;
        EXPECT_LE(glm::distance(end, turned(evaluate(curve, 0.3), axis, degrees * kPi / 180)), 1e-14 * size);
    }
}

TEST(Revolving, AFullTurnEndsWhereItBeganToTheBit)
{
    std::mt19937 random(93);
    const auto surface =
        revolved(randomCurve(random, {3, 4, 2}), {randomVector(random, 1), randomVector(random, 1)}, 360);
    for (int j = 0; j < surface->countV(); ++j)
        EXPECT_EQ(surface->controlPoint(0, j), surface->controlPoint(surface->countU() - 1, j));
    EXPECT_EQ(surface->knotsU().spans().size(), 8U);
}

TEST(Revolving, AHalfCircleGivesASphereWithPolesAndItsNormalsOutwards)
{
    std::mt19937 random(94);
    const Placement placement = randomPlacement(random, 3);
    const Mat4 matrix = placementMatrix(placement).value();
    std::vector<ControlPoint> points;  // from pole to pole, the way the axis points
    for (const ArcPoint& point : arcPoints(180))
        points.push_back({transformed(Vec3(2 * point.y, 0, -2 * point.x), matrix), point.weight});
    const auto meridian = NurbsCurve::create(arcKnots(4), std::move(points));
    const auto surface = revolved(*meridian, {placement.origin, placement.axis}, 360);
    ASSERT_TRUE(surface) << surface.error().sentence();
    for (int k = 0; k < 300; ++k) {
        const double u = randomIn(random, surface->knotsU());
        const double v = randomIn(random, surface->knotsV());
        const Vec3 from = evaluate(*surface, u, v).position - placement.origin;
        EXPECT_NEAR(glm::length(from), 2, 1e-13);
        EXPECT_NEAR(glm::dot(evaluateNormal(*surface, u, v).direction, from), 2, 1e-9);
    }
    for (const int j : {0, surface->countV() - 1})
        for (int i = 0; i < surface->countU(); ++i)
            EXPECT_EQ(surface->controlPoint(i, j).position, surface->controlPoint(0, j).position);
}

TEST(Revolving, PointsNormalsAwayFromTheAxisWhereTheCurveRunsItsWay)
{
    const auto surface = revolved(lineFrom({2, 0, 0}, {2, 0, 5}), {}, 360);
    const auto other = revolved(lineFrom({2, 0, 0}, {2, 0, 5}), {}, -90);
    EXPECT_GT(evaluateNormal(*surface, 0, 0.5).direction.x, 0.999);
    EXPECT_LT(evaluateNormal(*other, 0, 0.5).direction.x, -0.999);
    EXPECT_EQ(evaluate(*other, 2, 0).position, Vec3(0, -2, 0));
}

TEST(Revolving, RefusesWhatSweepsNoArea)
{
    const NurbsCurve line = lineFrom({1, 0, 0}, {1, 0, 3});
    for (const double degrees : {0.0, 360.001, -361.0, std::nan(""), 1e-300})
        EXPECT_FALSE(revolved(line, {}, degrees)) << degrees;
    EXPECT_FALSE(revolved(line, {Vec3(0), Vec3(0)}, 90));
    EXPECT_FALSE(revolved(line, {{std::nan(""), 0, 0}}, 90));
    EXPECT_FALSE(revolved(line, {{1, 0, -7}, {0, 0, 2}}, 90));
    EXPECT_FALSE(revolved(lineFrom({1, 2, 3}, {2, 4, 6}), {Vec3(0), {-1, -2, -3}}, 90));
    EXPECT_EQ(
        revolved(line, {}, 400).error().sentence(),
        "The angle is zero, more than a full turn, or no number. Give one of up to 360 degrees either way.");
}

}  // namespace knotspan::testing
