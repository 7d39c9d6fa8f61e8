#include "model/geometry/bezier_conversion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "tests/model/geometry/precise_evaluation.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

// One row of the matrix in 50 digits: de Boor's algorithm with an argument of its own at each level, on the
// unit vectors, in its other direction than the product's.
std::vector<Real> preciseRow(const KnotVector& knots, int span, int k)
{
    const int p = knots.degree();
    std::vector<Real> row;
    for (int unit = 0; unit <= p; ++unit) {
        std::vector<Real> d(static_cast<size_t>(p) + 1, Real(0));
        d[static_cast<size_t>(unit)] = 1;
        for (int r = 1; r <= p; ++r) {
            const Real argument = r <= k ? knots[span + 1] : knots[span];
            for (int j = p; j >= r; --j) {
                const Real low = knots[span - p + j];
                const Real high = knots[span + 1 + j - r];
                const Real alpha = (argument - low) / (high - low);
                d[static_cast<size_t>(j)] =
                    (1 - alpha) * d[static_cast<size_t>(j) - 1] + alpha * d[static_cast<size_t>(j)];
            }
        }
        row.push_back(d.back());
    }
    return row;
}

TEST(BezierMatrix, IsRightToAFewUnitsOfItsLastPlaceForAnyKnots)
{
    std::mt19937 random(11);
    double worst = 0;
    for (int degree = kMinDegree; degree <= kMaxDegree; ++degree)
        for (const double ratio : {1.0, 1e6})
            for (const bool clamped : {true, false}) {
                const KnotVector knots = randomKnots(random, degree, 3, ratio, clamped);
                for (const int span : knots.spans()) {
                    const std::vector<double> matrix = bezierMatrix(knots, span);
                    for (const int k : {0, (degree + 1) / 2, degree}) {
                        const std::vector<Real> exact = preciseRow(knots, span, k);
                        double sum = 0;
                        for (int c = 0; c <= degree; ++c) {
                            const double found = matrix[static_cast<size_t>(k * (degree + 1) + c)];
                            const Real& wanted = exact[static_cast<size_t>(c)];
                            EXPECT_GE(found, 0);
                            sum += found;
                            if (wanted == 0)
                                EXPECT_EQ(found, 0);
                            else
                                worst = std::max(
                                    worst, static_cast<double>(abs(Real(found) - wanted) / wanted) * 0x1p53);
                        }
                        EXPECT_NEAR(sum, 1, 1e-14);
                    }
                }
            }
    RecordProperty("units_of_the_last_place", std::to_string(worst));
    EXPECT_LT(worst, 64);
}

struct Case {
    NurbsSurface surface;
    Vec3 origin;
};

std::vector<Case> cases()
{
    std::mt19937 random(12);
    std::vector<Case> result;
    for (int trial = 0; trial < 12; ++trial) {
        const double offset = trial % 3 == 2 ? 1e6 : 0.0;
        result.push_back({randomSurface(random, {.degreeU = 1 + trial % 5,
                                                 .degreeV = 1 + (trial * 3) % 7,
                                                 .rational = trial % 2 == 0,
                                                 .offset = offset,
                                                 .spanRatio = trial % 4 == 3 ? 1e5 : 4.0,
                                                 .clamped = trial % 5 != 4}),
                          Vec3(offset)});
    }
    return result;
}

TEST(BezierNet, IsTheSurfaceToTheLastDigits)
{
    for (const Case& one : cases()) {
        const BezierConversion conversion(one.surface, one.origin);
        for (const KsQuad& quad : ksQuads(one.surface)) {
            const BezierNet net = conversion.net(quad);
            for (const double s : {0.3, 1.0})
                for (const double t : {0.0, 0.71}) {
                    const PrecisePoint exact = preciseEvaluation(
                        one.surface, quad.spanU, parameterOnSpan(one.surface.knotsU(), quad.spanU, s),
                        quad.spanV, parameterOnSpan(one.surface.knotsV(), quad.spanV, t));
                    const Vec4 found = evaluate(net, s, t);
                    for (int axis = 0; axis < 3; ++axis) {
                        const auto c = static_cast<size_t>(axis);
                        const double wanted = static_cast<double>(exact.position[c] - Real(one.origin[axis]));
                        EXPECT_NEAR(found[axis] / found.w, wanted, 2e-13);
                    }
                }
        }
    }
}

TEST(BezierNet, AgreesWithTheReferenceEvaluation)
{
    for (const Case& one : cases()) {
        const BezierConversion conversion(one.surface);
        const double digits = 4e-15 * (20 + 2 * one.origin.x);
        for (const KsQuad& quad : ksQuads(one.surface)) {
            const Vec4 found = evaluate(conversion.net(quad), 0.5, 0.5);
            const KnotVector& u = one.surface.knotsU();
            const KnotVector& v = one.surface.knotsV();
            const Vec3 wanted =
                evaluate(one.surface, u[quad.spanU] + 0.5 * (u[quad.spanU + 1] - u[quad.spanU]),
                         v[quad.spanV] + 0.5 * (v[quad.spanV + 1] - v[quad.spanV]))
                    .position;
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(found[axis] / found.w, wanted[axis], digits);
        }
    }
}

TEST(BezierNet, EnclosesItsKsQuadAndLiesInsideTheControlPointsThatShapeIt)
{
    for (const Case& one : cases()) {
        const BezierConversion conversion(one.surface, one.origin);
        for (const KsQuad& quad : ksQuads(one.surface)) {
            Box outer;
            for (int i = quad.spanU - one.surface.degreeU(); i <= quad.spanU; ++i)
                for (int j = quad.spanV - one.surface.degreeV(); j <= quad.spanV; ++j)
                    outer.add(one.surface.controlPoint(i, j).position - one.origin);
            const BezierNet net = conversion.net(quad);
            Box hull;
            for (const Vec4& point : net.points)
                hull.add(Vec3(point) / point.w);
            const double rounding = 1e-12;
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(hull.low[axis], outer.low[axis] - rounding);
                EXPECT_LE(hull.high[axis], outer.high[axis] + rounding);
            }
            for (const double s : {0.1, 0.5, 0.9})
                for (const double t : {0.2, 0.6}) {
                    const Vec4 point = evaluate(net, s, t);
                    for (int axis = 0; axis < 3; ++axis) {
                        EXPECT_GE(point[axis] / point.w, hull.low[axis] - rounding);
                        EXPECT_LE(point[axis] / point.w, hull.high[axis] + rounding);
                    }
                }
        }
    }
}

TEST(BezierNet, HasTheSameBitsOnBothSidesOfABorder)
{
    std::mt19937 random(13);
    int borders = 0;
    for (int degree = 1; degree <= 9; ++degree) {
        const NurbsSurface surface = randomSurface(random, {.degreeU = degree,
                                                            .degreeV = 10 - degree,
                                                            .spans = 5,
                                                            .rational = true,
                                                            .spanRatio = 100,
                                                            .clamped = degree % 2 == 0});
        const BezierConversion conversion(surface, Vec3(0.3, 0.2, 0.1));
        const auto& spansU = surface.knotsU().spans();
        const auto& spansV = surface.knotsV().spans();
        for (size_t k = 1; k < spansU.size(); ++k)
            for (size_t l = 1; l < spansV.size(); ++l) {
                const BezierNet here = conversion.net({spansU[k], spansV[l]});
                const BezierNet left = conversion.net({spansU[k - 1], spansV[l]});
                const BezierNet below = conversion.net({spansU[k], spansV[l - 1]});
                EXPECT_EQ(boundary(here, Side::startU), boundary(left, Side::endU));
                EXPECT_EQ(boundary(here, Side::startV), boundary(below, Side::endV));
                borders += 2;
            }
    }
    EXPECT_GT(borders, 100);
}

TEST(BezierNet, SplitsIntoPartsThatAreTheSameSurface)
{
    std::mt19937 random(14);
    const NurbsSurface surface = randomSurface(random, {.degreeU = 3, .degreeV = 5, .rational = true});
    const BezierNet net = BezierConversion(surface).net(ksQuads(surface).front());
    for (const Direction direction : {Direction::U, Direction::V})
        for (const double t : {0.5, 0.2}) {
            const auto [lower, upper] = split(net, direction, t);
            for (int k = 0; k < 20; ++k) {
                Vec2 at(randomBetween(random, 0, 1), randomBetween(random, 0, 1));
                const Vec4 inLower = evaluate(lower, at.x, at.y);
                const Vec4 inUpper = evaluate(upper, at.x, at.y);
                const int axis = direction == Direction::U ? 0 : 1;
                Vec2 below = at;
                Vec2 above = at;
                below[axis] = t * at[axis];
                above[axis] = t + (1 - t) * at[axis];
                const Vec4 wholeBelow = evaluate(net, below.x, below.y);
                const Vec4 wholeAbove = evaluate(net, above.x, above.y);
                for (int c = 0; c < 4; ++c) {
                    EXPECT_NEAR(inLower[c], wholeBelow[c], 1e-12);
                    EXPECT_NEAR(inUpper[c], wholeAbove[c], 1e-12);
                }
            }
        }
}

TEST(BezierNet, OfACurveReadBackwardsSplitsIntoTheSameBits)
{
    std::mt19937 random(15);
    BezierNet curve{7, 0, {}};
    for (int k = 0; k <= 7; ++k)
        curve.points.push_back({randomBetween(random, -1, 1), randomBetween(random, -1, 1),
                                randomBetween(random, -1, 1), randomBetween(random, 1, 2)});
    BezierNet backwards = curve;
    std::reverse(backwards.points.begin(), backwards.points.end());
    auto upper = split(backwards, Direction::U).second;
    std::reverse(upper.points.begin(), upper.points.end());
    EXPECT_EQ(split(curve, Direction::U).first, upper);
}

}  // namespace
}  // namespace knotspan::testing
