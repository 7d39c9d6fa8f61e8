// The figures of a meeting against the angle and the gap in 50 digits.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "tests/model/friends/meeting_samples.h"
#include "tests/model/friends/retold.h"
#include "tests/model/geometry/precise_evaluation.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

// Between the tangent planes at b's edge u = start and a's edge u = end, where both have the same v.
Real angleAtV(const NurbsSurface& a, const NurbsSurface& b, int span, double share)
{
    const Real v = parameterOnSpan(a.knotsV(), span, share);
    const int lastOfA = a.knotsU().spans().back();
    const PrecisePoint x = preciseEvaluation(a, lastOfA, Real(a.knotsU().domainEnd()), span, v);
    int spanOfB = b.knotsV().spans().front();
    for (const int candidate : b.knotsV().spans())
        if (Real(b.knotsV()[candidate]) <= v)
            spanOfB = candidate;
    const PrecisePoint y =
        preciseEvaluation(b, b.knotsU().spans().front(), Real(b.knotsU().domainStart()), spanOfB, v);
    const RealVec3 n = cross(x.du, x.dv);
    const RealVec3 m = cross(y.du, y.dv);
    return atan2(length(cross(n, m)), dot(n, m)) * 180 / boost::math::constants::pi<Real>();
}

// The largest of very many, refined around the largest.
Real trueAngle(const NurbsSurface& a, const NurbsSurface& b)
{
    constexpr int kSteps = 24;
    Real largest = 0;
    int best = a.knotsV().spans().front();
    double at = 0;
    const auto look = [&](int span, double share) {
        const Real angle = angleAtV(a, b, span, share);
        if (angle > largest) {
            largest = angle;
            best = span;
            at = share;
        }
    };
    for (const int span : a.knotsV().spans())
        for (int k = 0; k <= kSteps; ++k)
            look(span, static_cast<double>(k) / kSteps);
    for (double step = 0.5 / kSteps; step > 1e-5; step /= 2)
        for (const double way : {-step, step})
            look(best, std::clamp(at + way, 0.0, 1.0));
    return largest;
}

// A random pair with a common edge; breaks of `size` degrees or so that change along it.
MeetingPair uneven(std::mt19937& random, bool rational, double sizeDeg)
{
    const int degree = 3 + static_cast<int>(random() % 2);
    MeetingPair pair = splitSurface(random, {degree, 1, rational});
    const double size = std::tan(sizeDeg * std::numbers::pi / 180) * 0.3;
    std::vector<double> lift;
    for (int j = 0; j < pair.b.countV(); ++j)
        lift.push_back(randomBetween(random, -size, size));
    pair.b = surfaceOf(pair.b.knotsU(), pair.b.knotsV(), [&](int i, int j) {
        ControlPoint point = pair.b.controlPoint(i, j);
        if (i == 1)
            point.position += Vec3(0.1, 0.1, 1) * lift[static_cast<size_t>(j)];
        return point;
    });
    return pair;
}

}  // namespace

TEST(AngleBounds, AreNeverUnderTheTrueAngleAndWithinOnePercent)
{
    std::mt19937 random(91);
    for (const double size : {1e-4, 0.01, 0.1, 1.0, 20.0, 60.0})
        for (const bool rational : {false, true})
            for (int sample = 0; sample < 3; ++sample) {
                const MeetingPair pair = uneven(random, rational, size);
                const Real truth = trueAngle(pair.a, pair.b);
                const FriendTolerances tolerances{1e-3, size / 3, 0.01};
                for (const size_t told : {size_t{0}, size_t{4}, size_t{8}, size_t{9}}) {
                    const NurbsSurface b = retellings()[told].tell(pair.b);
                    const Friends friends({{&pair.a}, {&b}}, tolerances);
                    ASSERT_EQ(friends.edges().size(), 1U);
                    const FriendEdge& edge = friends.edges()[0];
                    // To the rounding of the control points that a retelling has.
                    const double rounding = 1e-10 + 1e-9 * size;
                    EXPECT_GE(Real(edge.angleBoundDeg) + rounding, truth) << size << ", " << told;
                    EXPECT_LE(Real(edge.angleMaxDeg), truth + rounding) << size << ", " << told;
                    const Real most = std::max(1.0101 * edge.angleMaxDeg, 0.01 * tolerances.angleDeg);
                    EXPECT_LE(edge.angleBoundDeg, most) << size << ", " << told;
                }
            }
}

// Breaks that are the tolerance times 0.99 and 1.01 at their largest, wherever that is.
TEST(AngleBounds, DecideUnevenBreaksByTheirLargest)
{
    std::mt19937 random(92);
    for (const bool rational : {false, true})
        for (int sample = 0; sample < 10; ++sample) {
            const MeetingPair pair = uneven(random, rational, 0.3);
            const auto truth = static_cast<double>(trueAngle(pair.a, pair.b));
            const auto& told = retellings()[random() % retellings().size()];
            const NurbsSurface b = told.tell(pair.b);
            for (const double factor : {0.99, 1.01}) {
                const Friends friends({{&pair.a}, {&b}}, {1e-3, truth / factor, 0.01});
                ASSERT_EQ(friends.edges().size(), 1U);
                EXPECT_EQ(friends.edges()[0].areFriends(), factor < 1) << told.name << ", " << truth;
            }
        }
}

// The middle control point of a straight edge is lifted: the gap is known, and no parameters agree.
TEST(GapBounds, AreNeverUnderTheTrueGapAndWithinOnePercentOfTheTolerance)
{
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const KnotVector along = KnotVector::clampedUniform(4, 1);
    for (const double height : {1e-5, 0.99e-3, 1.01e-3, 2.4e-3})
        for (const Retelling& retelling : retellings()) {
            const auto sheet = [&](double side, double bump) {
                return surfaceOf(line, along, [&](int i, int j) -> ControlPoint {
                    return {{side * i, j, j == 2 ? bump * 8 / 3 : 0}, 1};
                });
            };
            const NurbsSurface a = sheet(-1, 0);
            const NurbsSurface b = retelling.tell(sheet(1, height));
            const Friends friends({{&a}, {&b}});
            ASSERT_EQ(friends.edges().size(), 1U);
            const FriendEdge& edge = friends.edges()[0];
            EXPECT_GE(edge.gapMax, height * (1 - 1e-9)) << retelling.name;
            EXPECT_LE(edge.gapMax, std::max(1.0101 * height, 1e-5)) << retelling.name;
            EXPECT_EQ(edge.continuity == Continuity::none, height > 1e-3) << retelling.name;
        }
}

}  // namespace knotspan::testing
