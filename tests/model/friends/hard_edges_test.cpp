// Edges that made earlier versions answer wrongly: narrow, finely spanned, unevenly parametrized, closed,
// tiny.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "model/friends/friends.h"
#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

// A strip beside the edge `at`, to the side `away`.
template <class At>
NurbsSurface strip(const KnotVector& along, const Vec3& away, const At& at)
{
    return surfaceOf(KnotVector::clampedUniform(1, 1), along, [&](int i, int j) {
        return ControlPoint{at(j) + static_cast<double>(i) * away, 1};
    });
}

std::vector<FriendEdge> between(const Friends& friends)
{
    std::vector<FriendEdge> found;
    for (const FriendEdge& edge : friends.edges())
        if (edge.a.surface != edge.b.surface && edge.a.side == Side::startU && edge.b.side == Side::startU)
            found.push_back(edge);
    return found;
}

// A kink or a notch that lies within spans of `span`, between smooth ones.
KnotVector narrowKnots(double span)
{
    std::vector<double> knots(4, 0.0);
    for (int k = 0; k < 5; ++k)
        knots.push_back(0.5 + k * span);
    knots.insert(knots.end(), 4, 1.0);
    return KnotVector::create(3, knots).value();
}

}  // namespace

TEST(HardEdges, AKinkWithinSpansShorterThanTheGapIsFound)
{
    for (const double span : {2e-3, 5e-4, 1e-4, 2e-5}) {
        const KnotVector knots = narrowKnots(span);
        const auto at = [&](int j) { return Vec3(0, grevilleAbscissa(knots, j), 0); };
        const NurbsSurface a = strip(knots, {-1, 0, 0}, at);
        const NurbsSurface b = surfaceOf(KnotVector::clampedUniform(1, 1), knots, [&](int i, int j) {
            return ControlPoint{at(j) + Vec3(i, 0, i == 1 && j == 4 ? 0.1 : 0), 1};
        });
        const auto found = between(Friends({{&a}, {&b}}));
        ASSERT_EQ(found.size(), 1U) << span;
        EXPECT_STREQ(continuityName(found[0].continuity), "G0") << span;
        EXPECT_GT(found[0].angleMaxDeg, 3);
        EXPECT_NEAR(found[0].worst, 0.5 + 2 * span, 2 * span);
    }
}

TEST(HardEdges, ANotchOfAnyWidthIsNotBridged)
{
    for (const double width : {0.1, 0.01, 1e-3, 1e-4, 1e-5})
        for (const double depth : {0.004, 0.05, 1.0}) {
            const NurbsSurface a =
                strip(KnotVector::clampedUniform(1, 1), {-3, 0, 0}, [](int j) { return Vec3(0, 10 * j, 0); });
            const Vec3 corners[] = {{}, {0, 5, 0}, {depth, 5 + width / 2, 0}, {0, 5 + width, 0}, {0, 10, 0}};
            const NurbsSurface b =
                strip(clampedIntegerKnots(1, 4), {3, 0, 0}, [&](int j) { return corners[j]; });
            const auto found = between(Friends({{&a}, {&b}}));
            double covered = 0;
            for (const FriendEdge& edge : found) {
                EXPECT_FALSE(edge.areFriends() && edge.b.from < 1 - 0.01 && edge.b.to > 3 + 0.01)
                    << width << ' ' << depth;
                covered += edge.areFriends() ? edge.a.to - edge.a.from : 0;
            }
            EXPECT_GT(covered, 0.9) << width << ' ' << depth;
        }
}

TEST(HardEdges, OfVeryManySpansMeetOnce)
{
    for (const int spans : {800, 1300, 5000}) {
        const KnotVector knots = KnotVector::clampedUniform(3, spans);
        const auto at = [&](int j) { return Vec3(0, grevilleAbscissa(knots, j), 0); };
        const NurbsSurface a = strip(knots, {-1, 0, 0}, at);
        const NurbsSurface b = strip(knots, {1, 0, 0}, at);
        const auto found = between(Friends({{&a}, {&b}}));
        ASSERT_EQ(found.size(), 1U) << spans;
        EXPECT_STREQ(continuityName(found[0].continuity), "G2");
        EXPECT_EQ(found[0].a.to - found[0].a.from, 1);
    }
}

// The second edge is the first one with y = t + c t (t - 1/4) (t - 1/2) (t - 3/4) (t - 1).
TEST(HardEdges, OfUnevenParametersAreAsFarApartAsTheyAre)
{
    const KnotVector knots = KnotVector::clampedUniform(5, 1);
    const double powers[] = {0, 0.09375, -0.78125, 2.1875, -2.5, 1};
    const auto place = [&](double c, int j) {
        double sum = 0;
        double chosen[2] = {1, 1};  // C(j, i), C(5, i)
        for (int i = 0; i <= j; ++i) {
            sum += chosen[0] / chosen[1] * (c * powers[i] + (i == 1 ? 1 : 0));
            chosen[0] *= static_cast<double>(j - i) / (i + 1);
            chosen[1] *= static_cast<double>(5 - i) / (i + 1);
        }
        return sum;
    };
    for (const double share : {0.0, 0.99, 1.01})
        for (const double c : {0.05, 0.2, 1.0}) {
            const NurbsSurface a =
                strip(KnotVector::clampedUniform(1, 1), {-1, 0, 0}, [](int j) { return Vec3(0, j, 0); });
            const NurbsSurface b =
                strip(knots, {1, 0, 0}, [&](int j) { return Vec3(0, place(c, j), share * 1e-3); });
            const auto found = between(Friends({{&a}, {&b}}));
            ASSERT_EQ(found.size(), 1U);
            EXPECT_STREQ(continuityName(found[0].continuity), share > 1 ? "none" : "G2") << share << ' ' << c;
            EXPECT_LE(found[0].gapMax, share * 1e-3 + 6e-6);
            EXPECT_GE(found[0].gapMax, share * 1e-3 - 1e-12);
        }
}

// Speeds and normals that differ by hundreds within one span.
TEST(HardEdges, OfVeryUnevenSpeedStayG2)
{
    std::mt19937 random(7);
    const auto figure = [&] { return randomBetween(random, -1, 1); };
    const KnotVector knots = KnotVector::clampedUniform(5, 1);
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec3> points;
        for (int j = 0; j <= 5; ++j)
            points.emplace_back(3 * figure(), 0.3 * j + 3 * figure(), 3 * figure());
        const auto at = [&](int j) { return points[static_cast<size_t>(j)]; };
        const Vec3 away(-1, 0.3, 0.2);
        const NurbsSurface a = strip(knots, away, at);
        const NurbsSurface b = strip(knots, -away, at);
        const auto found = between(Friends({{&a}, {&b}}));
        ASSERT_EQ(found.size(), 1U) << round;
        EXPECT_STREQ(continuityName(found[0].continuity), "G2") << round;
        EXPECT_LE(found[0].curvatureMax, 1e-6);
    }
}

TEST(HardEdges, ThatCloseInOneSpanMeetWhole)
{
    std::mt19937 random(11);
    for (int round = 0; round < 20; ++round) {
        const KnotVector knots = KnotVector::clampedUniform(5, 1);
        std::vector<Vec3> points;
        for (int j = 0; j < 5; ++j)
            points.emplace_back(2 * std::cos(1.25 * j) + randomBetween(random, -0.2, 0.2),
                                2 * std::sin(1.25 * j), 0);
        points.push_back(points[0]);
        const auto at = [&](int j) { return points[static_cast<size_t>(round % 2 == 0 ? j : 5 - j)]; };
        const NurbsSurface a =
            strip(knots, {0, 0, -1}, [&](int j) { return points[static_cast<size_t>(j)]; });
        const NurbsSurface b = strip(knots, {0, 0, 1}, at);
        const auto found = between(Friends({{&a}, {&b}}));
        ASSERT_EQ(found.size(), 1U) << round;
        EXPECT_EQ(found[0].a.from, 0);
        EXPECT_EQ(found[0].a.to, 1);
        EXPECT_EQ(found[0].b.from, 0);
        EXPECT_EQ(found[0].b.to, 1);
        EXPECT_EQ(found[0].reversed, round % 2 == 1);
        EXPECT_TRUE(found[0].areFriends());
    }
}

// No tangent plane on the first span, a kink on later ones: the kink is what is certain.
TEST(HardEdges, WorstIsWhereTheVerdictComesFrom)
{
    const KnotVector knots = clampedIntegerKnots(1, 4);
    const auto at = [](int j) { return Vec3(0, j, 0); };
    const NurbsSurface a = strip(knots, {-1, 0, 0}, at);
    const NurbsSurface b = surfaceOf(KnotVector::clampedUniform(1, 1), knots, [&](int i, int j) {
        const double out = j < 2 ? 0 : 1;
        return ControlPoint{at(j) + static_cast<double>(i) * Vec3(out, 0, j == 3 ? 0.5 : 0), 1};
    });
    const auto found = between(Friends({{&a}, {&b}}));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_STREQ(continuityName(found[0].continuity), "G0");
    EXPECT_NEAR(found[0].worst, 3, 1e-9);
    EXPECT_EQ(found[0].angleBoundDeg, 180);
}

TEST(HardEdges, KeepTheirAngleAtAnySize)
{
    for (const double size : {1e-80, 1e-30, 1.0, 1e30, 1e60}) {
        const auto at = [&](int j) { return Vec3(0, size * j, 0); };
        const KnotVector knots = clampedIntegerKnots(1, 2);
        const NurbsSurface a = strip(knots, {-size, 0, 0}, at);
        const NurbsSurface b = strip(knots, {0.6 * size, 0, 0.8 * size}, at);
        FriendTolerances tolerances;
        tolerances.gap = 1e-4 * size;
        const auto found = between(Friends({{&a}, {&b}}, tolerances));
        ASSERT_EQ(found.size(), 1U) << size;
        EXPECT_STREQ(continuityName(found[0].continuity), "G0") << size;
        EXPECT_NEAR(found[0].angleMaxDeg, std::acos(0.6) * 180 / std::numbers::pi, 1e-9) << size;
    }
}

}  // namespace knotspan::testing
