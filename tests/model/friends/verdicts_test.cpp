// The verdict on pairs that were made to meet in a known way, told in many ways.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "tests/model/friends/meeting_samples.h"
#include "tests/model/friends/retold.h"

namespace knotspan::testing {

namespace {

constexpr double kGap = 1e-3;
constexpr double kAngle = 0.1;

Mat4 mirroredAndTurned()
{
    const Mat4 turned = glm::rotate(Mat4(1.0), 0.7, Vec3(1, 2, 3));
    return glm::scale(glm::translate(turned, Vec3(30, -20, 5)), Vec3(1, -1, 1));
}

// One meeting, along the whole of an edge, with this verdict; whichever way both are told.
void expectVerdict(const MeetingPair& pair, Continuity expected, const std::string& what)
{
    for (const Retelling& retelling : retellings())
        for (const bool both : {false, true}) {
            const NurbsSurface a = both ? retelling.tell(pair.b) : pair.a;
            const NurbsSurface b = both ? retellings().back().tell(pair.a) : retelling.tell(pair.b);
            for (const Mat4& transform : {Mat4(1.0), mirroredAndTurned()}) {
                const Friends friends({{&a, transform}, {&b, transform}});
                ASSERT_EQ(friends.edges().size(), 1U) << what << ", " << retelling.name;
                const FriendEdge& edge = friends.edges()[0];
                EXPECT_EQ(continuityName(edge.continuity), continuityName(expected))
                    << what << ", " << retelling.name << ": gap " << edge.gapMax << ", angle "
                    << edge.angleMaxDeg << " to " << edge.angleBoundDeg << ", curvature "
                    << edge.curvatureMax;
                EXPECT_EQ(friends.nakedEdges().size(), 6U) << what << ", " << retelling.name;
                EXPECT_LE(edge.angleMaxDeg, edge.angleBoundDeg);
            }
        }
}

}  // namespace

TEST(Verdicts, SurfacesCutAtAKnotMeetAsSmoothlyAsTheKnotIs)
{
    std::mt19937 random(61);
    for (const int degree : {3, 5})
        for (const bool rational : {false, true})
            for (const int smoothness : {2, 1, 0}) {
                const Continuity expected = smoothness == 2   ? Continuity::g2
                                            : smoothness == 1 ? Continuity::g1
                                                              : Continuity::g0;
                expectVerdict(splitSurface(random, {degree, degree - smoothness, rational}), expected,
                              "degree " + std::to_string(degree) + (rational ? " rational" : "") + ", C" +
                                  std::to_string(smoothness));
            }
}

TEST(Verdicts, ABreakIsJudgedByTheToleranceToOnePercent)
{
    std::mt19937 random(62);
    for (const bool rational : {false, true})
        for (const int order : {1, 2}) {
            const Continuity smooth = order == 1 ? Continuity::g1 : Continuity::g2;
            for (const double sign : {-1.0, 1.0}) {
                expectVerdict(hinge(random, {order, rational, sign * 0.99 * kAngle, 0}), smooth,
                              "0.99 of a break");
                expectVerdict(hinge(random, {order, rational, sign * 1.01 * kAngle, 0}), Continuity::g0,
                              "1.01 of a break");
            }
        }
    expectVerdict(cones(0.99 * kAngle), Continuity::g2, "0.99 of a break on a circle");
    expectVerdict(cones(-1.01 * kAngle), Continuity::g0, "1.01 of a break on a circle");
}

TEST(Verdicts, KinksAreG0WithTheirAngle)
{
    std::mt19937 random(63);
    for (const double angle : {0.5, 5.0, 45.0, 90.0, 120.0, 170.0}) {
        expectVerdict(hinge(random, {2, false, angle, 0}), Continuity::g0, "hinge");
        expectVerdict(cones(angle), Continuity::g0, "cones");
        const MeetingPair pair = hinge(random, {1, true, angle, 0});
        const Friends friends({{&pair.a}, {&pair.b}});
        ASSERT_EQ(friends.edges().size(), 1U);
        EXPECT_NEAR(friends.edges()[0].angleMaxDeg, angle, 1e-9);
        EXPECT_NEAR(friends.edges()[0].angleBoundDeg, angle, 0.01 * angle);
    }
}

// Sides of a cusp run along each other as well for a little, near the corners: the long meeting counts.
TEST(Verdicts, ACuspIsAKinkNotAFriend)
{
    std::mt19937 random(64);
    for (const int order : {1, 2})
        for (const bool rational : {false, true}) {
            const MeetingPair pair = hinge(random, {order, rational, 180, 0});
            for (const Retelling& retelling : retellings()) {
                const NurbsSurface b = retelling.tell(pair.b);
                const Friends friends({{&pair.a}, {&b}});
                int whole = 0;
                for (const FriendEdge& edge : friends.edges())
                    if (edge.a.side == Side::endU && edge.a.to - edge.a.from == 4.0) {
                        ++whole;
                        EXPECT_STREQ(continuityName(edge.continuity), "G0") << retelling.name;
                        EXPECT_NEAR(edge.angleMaxDeg, 180, 1e-6);
                        EXPECT_FALSE(edge.areFriends());
                    }
                EXPECT_EQ(whole, 1) << retelling.name;
            }
        }
}

// The second row of control points stands on the first: no tangent plane anywhere along the edge.
TEST(Verdicts, WithoutATangentPlaneItIsUndetermined)
{
    std::mt19937 random(68);
    MeetingPair pair = hinge(random, {2, false, 0, 0});
    pair.b = surfaceOf(pair.b.knotsU(), pair.b.knotsV(),
                       [&](int i, int j) { return pair.b.controlPoint(i == 1 ? 0 : i, j); });
    expectVerdict(pair, Continuity::undetermined, "rows on each other");
    const Friends friends({{&pair.a}, {&pair.b}});
    EXPECT_EQ(friends.edges()[0].angleBoundDeg, 180);
}

// At one place of the edge only: all control points that stand for the derivative across it there.
TEST(Verdicts, WithoutATangentPlaneAtOnePlaceWithinItIsUndetermined)
{
    std::mt19937 random(69);
    MeetingPair pair = hinge(random, {2, false, 0, 0});
    const auto pinched = [](const NurbsSurface& surface, bool last) {
        const NurbsSurface fine = withKnotInserted(surface, Direction::V, 1.7, 2);
        const int edge = last ? fine.countU() - 1 : 0;
        const int next = last ? edge - 1 : 1;
        return surfaceOf(fine.knotsU(), fine.knotsV(),
                         [&](int i, int j) { return fine.controlPoint(i == next && j == 3 ? edge : i, j); });
    };
    pair = {pinched(pair.a, true), pinched(pair.b, false)};
    const Friends friends({{&pair.a}, {&pair.b}});
    ASSERT_EQ(friends.edges().size(), 1U);
    EXPECT_STREQ(continuityName(friends.edges()[0].continuity), "undetermined");
    EXPECT_NEAR(friends.edges()[0].worst, 1.7, 1e-9);
}

TEST(Verdicts, AGapIsJudgedByTheToleranceToOnePercent)
{
    std::mt19937 random(65);
    for (const double sign : {-1.0, 1.0}) {
        expectVerdict(hinge(random, {1, false, 0, sign * 0.99 * kGap}), Continuity::g1, "0.99 of a gap");
        expectVerdict(hinge(random, {2, true, 0, sign * 0.99 * kGap}), Continuity::g2, "0.99 of a gap");
        expectVerdict(hinge(random, {1, true, 0, sign * 1.01 * kGap}), Continuity::none, "1.01 of a gap");
        expectVerdict(hinge(random, {0, false, 0, sign * 2.5 * kGap}), Continuity::none, "2.5 of a gap");
        expectVerdict(cones(0, sign * 0.99 * kGap), Continuity::g2, "0.99 of a gap on a circle");
        expectVerdict(cones(30, sign * 1.01 * kGap), Continuity::none, "1.01 of a gap on a circle");
    }
}

TEST(Verdicts, ABreakOfCurvatureIsJudgedByTheToleranceToOnePercent)
{
    for (const double curvature : {0.2, 1.0, 3.0})
        for (const double factor : {0.99, 1.01}) {
            const Continuity expected = factor < 1 ? Continuity::g2 : Continuity::g1;
            const double other = curvature * (1 - factor * 0.01);
            expectVerdict(cylinders(curvature, other), expected, "to the flatter one");
            expectVerdict(cylinders(other, curvature), expected, "to the more curved one");
            const MeetingPair pair = cylinders(curvature, other);
            const Friends friends({{&pair.a}, {&pair.b}});
            ASSERT_EQ(friends.edges().size(), 1U);
            EXPECT_NEAR(friends.edges()[0].curvatureMax, curvature - other, 1e-9);
        }
}

// The circle's parameter runs unevenly, as no projective map does: matching has to find who belongs to whom.
TEST(Verdicts, HoldWhereParametersAreUnrelated)
{
    for (const double bend : {0.2, 0.4, 0.8})
        for (const double factor : {0.99, 1.01}) {
            MeetingPair pair = cones(factor * kAngle, 0.5 * kGap);
            pair.b = unevenV(pair.b, bend);
            expectVerdict(pair, factor < 1 ? Continuity::g2 : Continuity::g0, "uneven circle");
            pair = cones(30, factor * kGap);
            pair.a = unevenV(pair.a, bend);
            expectVerdict(pair, factor < 1 ? Continuity::g0 : Continuity::none, "uneven circle");
        }
}

TEST(Verdicts, FurtherThanThreeTolerancesEdgesAreNaked)
{
    std::mt19937 random(66);
    const MeetingPair pair = hinge(random, {2, false, 0, 4 * kGap});
    const Friends friends({{&pair.a}, {&pair.b}});
    EXPECT_TRUE(friends.edges().empty());
    EXPECT_EQ(friends.nakedEdges().size(), 8U);
}

TEST(Verdicts, HoldFarFromTheOriginAndAtAnySize)
{
    std::mt19937 random(67);
    for (const double size : {1e-3, 1.0, 1e4}) {
        const double coarse = kGap * size;
        for (const bool smooth : {true, false}) {
            const MeetingPair pair = hinge(random, {2, true, smooth ? 0.09 : 0.11, 0.9 * kGap});
            const Mat4 transform =
                glm::scale(glm::translate(Mat4(1.0), size * Vec3(1e6, -1e6, 3e5)), Vec3(size));
            const Friends friends({{&pair.a, transform}, {&pair.b, transform}}, {coarse, kAngle, 0.01});
            ASSERT_EQ(friends.edges().size(), 1U) << size;
            EXPECT_STREQ(continuityName(friends.edges()[0].continuity), smooth ? "G2" : "G0") << size;
        }
    }
}

}  // namespace knotspan::testing
