// Lofts against the curves that they lead through.
#include "model/making/loft.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/making/compatible_curves.h"
#include "tests/model/making/making_samples.h"

namespace knotspan::testing {

namespace {

// From t of `from` to the same share of `to`.
double carried(double t, const KnotVector& from, const KnotVector& to)
{
    return std::lerp(to.domainStart(), to.domainEnd(),
                     (t - from.domainStart()) / (from.domainEnd() - from.domainStart()));
}

// Unequal degrees, knots, domains and, every other time, weights. Side by side, or round a ring.
std::vector<NurbsCurve> someCurves(std::mt19937& random, int count, int round, bool ring)
{
    std::vector<NurbsCurve> curves;
    for (int k = 0; k < count; ++k) {
        RandomCurveShape shape{1 + (round + k) % 5, 1 + (round + 2 * k) % 4, round % 2 == 1 ? 1.15 : 1.0,
                               (round + k) % 5 != 2};
        const double angle = 6.28 * k / count;
        shape.offset = ring ? 3.0 * Vec3(0, std::cos(angle), std::sin(angle)) : Vec3(0, 0, 1.5 * k);
        shape.offset += round % 6 == 5 ? Vec3(1e4) : Vec3(0);
        curves.push_back(randomCurve(random, shape));
    }
    return curves;
}

void expectThrough(std::mt19937& random, const Loft& loft, const std::vector<NurbsCurve>& curves)
{
    const double size = reachOf(loft.surface.bounds());
    for (size_t k = 0; k < curves.size(); ++k) {
        const auto iso = isoCurve(loft.surface, Direction::V, loft.parameters[k]);
        ASSERT_TRUE(iso);
        for (int place = 0; place < 40; ++place) {
            const double u = randomIn(random, loft.surface.knotsU());
            const Vec3 expected = evaluate(curves[k], carried(u, loft.surface.knotsU(), curves[k].knots()));
            EXPECT_LE(glm::distance(evaluate(*iso, u), expected), 1e-12 * size)
                << k << " of " << curves.size();
            const Vec3 at = evaluate(loft.surface, u, loft.parameters[k]).position;
            EXPECT_LE(glm::distance(at, expected), 1e-12 * size) << k << " of " << curves.size();
        }
    }
}

}  // namespace

TEST(CompatibleCurves, HaveOneSetOfKnotsAndTheirOwnShapes)
{
    std::mt19937 random(51);
    for (int round = 0; round < 40; ++round) {
        const std::vector<NurbsCurve> curves = someCurves(random, 1 + round % 5, round, false);
        const auto same = compatibleCurves(curves);
        ASSERT_TRUE(same) << same.error().sentence();
        for (size_t k = 0; k < curves.size(); ++k) {
            const NurbsCurve& curve = (*same)[k];
            EXPECT_EQ(curve.knots(), same->front().knots());
            for (int place = 0; place < 30; ++place) {
                const double t = randomIn(random, curve.knots());
                const Vec3 expected = evaluate(curves[k], carried(t, curve.knots(), curves[k].knots()));
                EXPECT_LE(glm::distance(evaluate(curve, t), expected), 1e-13 * reachOf(curves[k].bounds()));
            }
        }
    }
}

TEST(CompatibleCurves, KeepCornersAndBreaksOfTheirOwn)
{
    // A polyline through a circle's eighths gets the circle's knots and keeps its corners.
    std::vector<ControlPoint> corners;
    for (int k = 0; k <= 8; ++k)
        corners.push_back({{k % 3, k * k, 1}, 1});
    const NurbsCurve line = NurbsCurve::create(KnotVector::clampedUniform(1, 8), corners).value();
    const auto same = compatibleCurves({circleAt(0, 1), line});
    ASSERT_TRUE(same);
    EXPECT_EQ(same->front(), circleAt(0, 1));
    for (size_t k = 0; k <= 8; ++k)
        EXPECT_EQ((*same)[1].controlPoints()[2 * k], corners[k]);
}

TEST(CompatibleCurves, KeepCurvesThatAreAlreadyToTheBit)
{
    const std::vector<NurbsCurve> circles{circleAt(0, 1), circleAt(2, 3)};
    EXPECT_EQ(compatibleCurves(circles).value(), circles);
}

TEST(CompatibleCurves, TakeKnotsThatDifferByRoundingForOne)
{
    const auto withKnot = [](double end, double knot) {
        std::vector<ControlPoint> points{{{0, 0, 0}, 1}, {{1, 1, 0}, 1}, {{2, 0, 0}, 1}, {{3, 1, 0}, 1}};
        return NurbsCurve::create(KnotVector::create(2, {0, 0, 0, knot, end, end, end}).value(), points)
            .value();
    };
    // 0.1 / 0.3 is not 1 / 3 to the bit.
    const auto same = compatibleCurves({withKnot(0.3, 0.1), withKnot(3, 1), withKnot(7, 7.0 / 3)});
    ASSERT_TRUE(same);
    EXPECT_EQ(same->front().knots().values().size(), 7U);
}

TEST(Lofting, LeadsThroughEveryCurve)
{
    std::mt19937 random(52);
    for (const int count : {2, 3, 7, 20})
        for (int round = 0; round < 20; ++round) {
            const std::vector<NurbsCurve> curves = someCurves(random, count, round, false);
            const auto loft = lofted(curves, LoftEnds::open);
            ASSERT_TRUE(loft) << loft.error().sentence();
            EXPECT_EQ(loft->surface.degreeV(), std::min(3, count - 1));
            EXPECT_EQ(loft->surface.countV(), count);
            EXPECT_EQ(loft->surface.isRational(), round % 2 == 1);
            EXPECT_EQ(loft->parameters.front(), 0);
            EXPECT_EQ(loft->parameters.back(), 1);
            expectThrough(random, *loft, curves);
        }
}

TEST(Lofting, ClosesAsSmoothlyAsItRuns)
{
    std::mt19937 random(53);
    for (const int count : {3, 4, 7})
        for (int round = 0; round < 12; ++round) {
            const std::vector<NurbsCurve> curves = someCurves(random, count, round, true);
            const auto loft = lofted(curves, LoftEnds::closed);
            ASSERT_TRUE(loft) << loft.error().sentence();
            const NurbsSurface& surface = loft->surface;
            expectThrough(random, *loft, curves);
            EXPECT_EQ(isoCurve(surface, Direction::V, 0).value(), isoCurve(surface, Direction::V, 1).value());
            for (int place = 0; place < 20; ++place) {
                const double u = randomIn(random, surface.knotsU());
                const SurfacePoint start = evaluate(surface, u, 0);
                const SurfacePoint end = evaluate(surface, u, 1);
                EXPECT_LE(glm::distance(start.dv, end.dv), 1e-9 * reachOf(surface.bounds()));
                EXPECT_LE(glm::distance(start.dvv, end.dvv), 1e-7 * reachOf(surface.bounds()));
            }
        }
}

TEST(Lofting, ThroughEqualCirclesIsACylinder)
{
    const auto loft = lofted({circleAt(0, 2), circleAt(1, 2), circleAt(4, 2), circleAt(5, 2), circleAt(9, 2)},
                             LoftEnds::open);
    ASSERT_TRUE(loft);
    for (double u = 0; u <= 8; u += 0.3)
        for (double v = 0; v <= 1; v += 0.03) {
            const Vec3 at = evaluate(loft->surface, u, v).position;
            EXPECT_NEAR(std::hypot(at.x, at.y), 2, 1e-13);
            EXPECT_NEAR(at.z, 9 * v, 1e-13);  // spaced by distance
        }
}

TEST(Lofting, MayEndInAPoint)
{
    const auto loft = lofted({circleAt(0, 1), circleAt(1, 1.5), circleAt(2, 0)}, LoftEnds::open);
    ASSERT_TRUE(loft) << loft.error().sentence();
    for (int i = 0; i < loft->surface.countU(); ++i)
        EXPECT_EQ(loft->surface.controlPoint(i, 2).position, Vec3(0, 0, 2));
}

TEST(Lofting, DoesNotDependOnAWeightThatAllPointsOfACurveShare)
{
    std::mt19937 random(54);
    const std::vector<NurbsCurve> curves = someCurves(random, 4, 1, false);
    std::vector<NurbsCurve> heavier = curves;
    std::vector<ControlPoint> points = curves[2].controlPoints();
    for (ControlPoint& point : points)
        point.weight *= 1024;
    heavier[2] = NurbsCurve::create(curves[2].knots(), points).value();
    EXPECT_EQ(lofted(curves, LoftEnds::open).value().surface,
              lofted(heavier, LoftEnds::open).value().surface);
}

TEST(Lofting, RefusesWhatIsNoRowOfCurves)
{
    const std::vector<NurbsCurve> two{circleAt(0, 1), circleAt(1, 1)};
    EXPECT_FALSE(lofted({}, LoftEnds::open));
    EXPECT_FALSE(lofted({two[0]}, LoftEnds::open));
    EXPECT_FALSE(lofted(two, LoftEnds::closed));
    EXPECT_FALSE(lofted({two[0], two[1], two[1]}, LoftEnds::open));
    EXPECT_FALSE(lofted({two[0], two[1], circleAt(2, 1), two[0]}, LoftEnds::closed));
    EXPECT_FALSE(lofted(std::vector<NurbsCurve>(1001, two[0]), LoftEnds::open));
    EXPECT_FALSE(lofted({two[0], circleAt(1e200, 1)}, LoftEnds::open));
    EXPECT_EQ(lofted({two[0]}, LoftEnds::open).error().sentence(),
              "A loft needs at least two curves. Choose more curves.");
}

TEST(Lofting, RefusesWeightsThatWouldTurnNegative)
{
    std::vector<NurbsCurve> curves;
    for (const double weight : {1.0, 1.0, 1000.0, 1.0}) {
        const double z = static_cast<double>(curves.size());
        curves.push_back(NurbsCurve::create(KnotVector::clampedUniform(2, 1),
                                            {{{0, 0, z}, 1}, {{1, 1, z}, weight}, {{2, 0, z}, 1}})
                             .value());
    }
    const auto loft = lofted(curves, LoftEnds::open);
    ASSERT_FALSE(loft);
    EXPECT_EQ(loft.error().what,
              "The curves' weights are so different that no surface leads smoothly through them");
}

}  // namespace knotspan::testing
