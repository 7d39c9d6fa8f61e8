// Curves against the surfaces that they were taken from.
#include "model/geometry/nurbs_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "tests/model/making/making_samples.h"

namespace knotspan::testing {

namespace {

NurbsSurface anySurface(std::mt19937& random, int round)
{
    RandomSurfaceShape shape;
    shape.degreeU = 1 + round % 5;
    shape.degreeV = 1 + round / 5 % 5;
    shape.spans = 1 + round % 4;
    shape.rational = round % 2 == 1;
    shape.clamped = round % 7 != 3;
    shape.offset = round % 11 == 5 ? 1e5 : 0;
    return randomSurface(random, shape);
}

void expectOnSurface(std::mt19937& random, const NurbsSurface& surface, Direction across, double parameter)
{
    const auto curve = isoCurve(surface, across, parameter);
    ASSERT_TRUE(curve) << curve.error().sentence();
    const bool alongV = across == Direction::U;
    EXPECT_EQ(curve->knots(), alongV ? surface.knotsV() : surface.knotsU());
    for (int k = 0; k < 20; ++k) {
        const double t = randomIn(random, curve->knots());
        const Vec3 expected =
            (alongV ? evaluate(surface, parameter, t) : evaluate(surface, t, parameter)).position;
        EXPECT_LE(glm::distance(evaluate(*curve, t), expected), 1e-14 * reachOf(surface.bounds()));
    }
}

}  // namespace

TEST(NurbsCurve, RefusesWhatIsNoCurveWithASentence)
{
    const KnotVector knots = KnotVector::clampedUniform(1, 1);
    const double nan = std::nan("");
    EXPECT_EQ(NurbsCurve::create(knots, {{Vec3(0), 1}}).error().sentence(),
              "The knots ask for 2 control points, but there are 1.");
    EXPECT_EQ(NurbsCurve::create(knots, {{Vec3(0), 1}, {{0, nan, 0}, 1}}).error().sentence(),
              "Control point 1 has a coordinate that is not a finite number.");
    EXPECT_EQ(NurbsCurve::create(knots, {{Vec3(0), nan}, {Vec3(1), 1}}).error().sentence(),
              "Control point 0 has a weight that is not a finite number.");
    EXPECT_EQ(NurbsCurve::create(knots, {{Vec3(0), 1}, {Vec3(1), 0}}).error().sentence(),
              "Control point 1 has a weight that is not above zero.");
}

TEST(NurbsCurve, FromASurfaceRunsThroughItsPoints)
{
    std::mt19937 random(71);
    for (int round = 0; round < 150; ++round) {
        const NurbsSurface surface = anySurface(random, round);
        for (const Direction across : {Direction::U, Direction::V}) {
            const KnotVector& knots = across == Direction::U ? surface.knotsU() : surface.knotsV();
            const int middle = knots.spans()[knots.spans().size() / 2];
            for (const double parameter :
                 {randomIn(random, knots), knots[middle], knots.domainStart(), knots.domainEnd()})
                expectOnSurface(random, surface, across, parameter);
        }
    }
}

TEST(NurbsCurve, AtABorderHasTheNetsOwnPointsToTheBit)
{
    const NurbsSurface surface = sphere({1, 2, 3}, 2);
    const NurbsCurve end = isoCurve(surface, Direction::U, surface.knotsU().domainEnd()).value();
    const NurbsCurve pole = isoCurve(surface, Direction::V, surface.knotsV().domainStart()).value();
    for (int j = 0; j < surface.countV(); ++j)
        EXPECT_EQ(end.controlPoints()[static_cast<size_t>(j)], surface.controlPoint(surface.countU() - 1, j));
    for (const ControlPoint& point : pole.controlPoints())
        EXPECT_EQ(point.position, Vec3(1, 2, 1));
}

TEST(NurbsCurve, OutsideOfASurfaceIsRefused)
{
    const NurbsSurface surface = sphere(Vec3(0), 1);
    for (const double parameter : {-0.1, 4.1, std::nan("")})
        EXPECT_FALSE(isoCurve(surface, Direction::V, parameter)) << parameter;
    EXPECT_EQ(isoCurve(surface, Direction::V, 5).error().sentence(),
              "5 is not inside the surface's domain. Choose a parameter from 0 to 4.");
}

TEST(NurbsCurve, TurnedRoundTwiceIsItselfToTheBit)
{
    std::mt19937 random(72);
    for (int round = 0; round < 20; ++round) {
        const NurbsCurve curve = randomCurve(random, {1 + round % 5, 4, 3, round % 3 != 0});
        const NurbsCurve turned = reversed(curve);
        EXPECT_EQ(reversed(turned), curve);
        const double t = randomIn(random, curve.knots());
        EXPECT_LE(glm::distance(evaluate(turned, -t), evaluate(curve, t)), 1e-14 * reachOf(curve.bounds()));
    }
}

TEST(NurbsCurve, IsMovedPointByPoint)
{
    std::mt19937 random(73);
    const NurbsCurve curve = randomCurve(random, {3, 5, 4});
    Mat4 matrix(1.0);
    for (int column = 0; column < 4; ++column)
        matrix[column] += Vec4(randomVector(random, 1), 0);
    const NurbsCurve moved = transformed(curve, matrix).value();
    for (int k = 0; k < 100; ++k) {
        const double t = randomIn(random, curve.knots());
        EXPECT_LE(glm::distance(evaluate(moved, t), transformed(evaluate(curve, t), matrix)), 1e-13);
    }
    EXPECT_FALSE(transformed(curve, Mat4(std::numeric_limits<double>::max())));
}

TEST(NurbsCurve, IsEvaluatedAtItsEndsAndWithAnyWeights)
{
    const NurbsCurve curve = NurbsCurve::create(KnotVector::clampedUniform(2, 1),
                                                {{{0, 0, 0}, 1e300}, {{1, 1, 0}, 1e-300}, {{2, 0, 0}, 1e300}})
                                 .value();
    EXPECT_EQ(evaluate(curve, -7), Vec3(0, 0, 0));
    EXPECT_EQ(evaluate(curve, std::nan("")), Vec3(0, 0, 0));
    EXPECT_EQ(evaluate(curve, 7), Vec3(2, 0, 0));
    EXPECT_EQ(evaluate(curve, 0.5), Vec3(1, 0, 0));
}

}  // namespace knotspan::testing
