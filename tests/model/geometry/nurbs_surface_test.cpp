#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "model/geometry/ksquad.h"
#include "model/geometry/primitives.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {
namespace {

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

std::vector<ControlPoint> sixPoints()
{
    return {{{0, 0, 0}, 1}, {{0, 1, 0}, 1}, {{1, 0, 0}, 1}, {{1, 1, 0}, 1}, {{2, 0, 0}, 1}, {{2, 1, 0}, 1}};
}

std::string refusal(std::vector<ControlPoint> points)
{
    const auto result = NurbsSurface::create(KnotVector::clampedUniform(2, 1),
                                             KnotVector::clampedUniform(1, 1), std::move(points));
    return result ? "" : result.error().sentence();
}

std::string refusalWith(const ControlPoint& bad)
{
    auto points = sixPoints();
    points[3] = bad;
    return refusal(points);
}

TEST(NurbsSurface, RefusesANetOfTheWrongSizeWithASentence)
{
    EXPECT_EQ(refusal(sixPoints()), "");
    EXPECT_EQ(refusal({}), "The knots ask for 3 x 2 = 6 control points, but there are 0.");
}

TEST(NurbsSurface, RefusesNumbersThatAreNotFiniteNamingTheControlPoint)
{
    EXPECT_EQ(refusalWith({{0, kNan, 0}, 1}),
              "Control point (1, 1) has a coordinate that is not a finite number.");
    EXPECT_EQ(refusalWith({{0, 0, -kInfinity}, 1}),
              "Control point (1, 1) has a coordinate that is not a finite number.");
    EXPECT_EQ(refusalWith({{0, 0, 0}, kNan}),
              "Control point (1, 1) has a weight that is not a finite number.");
    EXPECT_EQ(refusalWith({{0, 0, 0}, kInfinity}),
              "Control point (1, 1) has a weight that is not a finite number.");
}

TEST(NurbsSurface, RefusesWeightsThatAreNotAboveZeroNamingTheControlPoint)
{
    EXPECT_EQ(refusalWith({{0, 0, 0}, 0}), "Control point (1, 1) has a weight that is not above zero.");
    EXPECT_EQ(refusalWith({{0, 0, 0}, -1}), "Control point (1, 1) has a weight that is not above zero.");
}

TEST(NurbsSurface, IsRationalOnlyWhereWeightsDiffer)
{
    auto points = sixPoints();
    for (ControlPoint& point : points)
        point.weight = 0.5;
    const auto u = KnotVector::clampedUniform(2, 1);
    const auto v = KnotVector::clampedUniform(1, 1);
    EXPECT_FALSE(NurbsSurface::create(u, v, points)->isRational());
    points[4].weight = 1;
    EXPECT_TRUE(NurbsSurface::create(u, v, points)->isRational());
}

TEST(NurbsSurface, KnowsWhichWayItIsClosed)
{
    EXPECT_TRUE(sphere({5, 5, 5}, 2).isClosedU());
    EXPECT_FALSE(sphere({5, 5, 5}, 2).isClosedV());
    EXPECT_TRUE(torus({5, 5, 5}, 2, 1).isClosedU());
    EXPECT_TRUE(torus({5, 5, 5}, 2, 1).isClosedV());
    EXPECT_FALSE(plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}).isClosedU());
}

TEST(NurbsSurface, IsClosedWhereAnUnclampedNetWrapsRound)
{
    // A triangle's three points over and over: a closed uniform quadratic.
    const auto u = *KnotVector::create(2, {0, 1, 2, 3, 4, 5, 6, 7});
    const auto v = KnotVector::clampedUniform(1, 1);
    std::vector<ControlPoint> points;
    const Vec3 corners[] = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 2; ++j)
            points.push_back({corners[i % 3] + Vec3(0, 0, j), 1});
    EXPECT_TRUE(NurbsSurface::create(u, v, points)->isClosedU());
    EXPECT_FALSE(NurbsSurface::create(u, v, points)->isClosedV());
}

TEST(KsQuads, AreTheNonEmptySpansUOuterVInner)
{
    const auto quads = ksQuads(sphere({0, 0, 0}, 1));
    ASSERT_EQ(quads.size(), 32u);
    EXPECT_EQ(ksQuadCount(sphere({0, 0, 0}, 1)), 32u);
    EXPECT_EQ(quads[0].spanU, 2);
    EXPECT_EQ(quads[1].spanU, 2);
    EXPECT_EQ(quads[1].spanV, 4);
    EXPECT_EQ(quads[4].spanU, 4);
}

TEST(TrimCurve, RefusesWhatIsNoCurveWithASentence)
{
    const auto knots = KnotVector::clampedUniform(1, 1);
    const auto sentence = [&](std::vector<TrimPoint> points) {
        const auto result = TrimCurve::create(knots, std::move(points));
        return result ? "" : result.error().sentence();
    };
    EXPECT_EQ(sentence({{{0, 0}, 1}, {{1, 0}, 1}}), "");
    EXPECT_EQ(sentence({{{0, 0}, 1}}), "The knots ask for 2 control points, but there are 1.");
    EXPECT_EQ(sentence({{{0, kNan}, 1}, {{1, 0}, 1}}),
              "Control point 0 has a coordinate that is not a finite number.");
    EXPECT_EQ(sentence({{{0, 0}, 1}, {{1, 0}, 0}}), "Control point 1 has a weight that is not above zero.");
    EXPECT_EQ(sentence({{{0, 0}, 1}, {{1, 0}, kInfinity}}),
              "Control point 1 has a weight that is not a finite number.");
}

TEST(TrimCurve, EvaluatesARationalArcToACircle)
{
    const double c = std::sqrt(0.5);
    const auto arc =
        *TrimCurve::create(KnotVector::clampedUniform(2, 1), {{{1, 0}, 1}, {{1, 1}, c}, {{0, 1}, 1}});
    for (double t = 0; t <= 1; t += 0.125) {
        const Vec2 point = arc.evaluate(t);
        EXPECT_NEAR(std::hypot(point.x, point.y), 1, 1e-15);
    }
    EXPECT_EQ(arc.evaluate(0), Vec2(1, 0));
    EXPECT_EQ(arc.evaluate(1), Vec2(0, 1));
}

}  // namespace
}  // namespace knotspan
