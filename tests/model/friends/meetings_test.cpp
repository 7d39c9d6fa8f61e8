// Which parts of edges are found to meet, and which are naked.
#include <gtest/gtest.h>

#include <cmath>

#include "model/friends/friends.h"
#include "model/geometry/knot_insertion.h"
#include "model/geometry/primitives.h"
#include "model/samples/net.h"
#include "model/samples/sample_list.h"
#include "tests/joined_surfaces.h"
#include "tests/model/friends/meeting_samples.h"
#include "tests/model/friends/retold.h"

namespace knotspan::testing {

namespace {

std::vector<FriendEdge> meetingsOf(const Friends& friends, std::uint32_t a, std::uint32_t b)
{
    std::vector<FriendEdge> found;
    for (const FriendEdge& edge : friends.edges())
        if (edge.a.surface == a && edge.b.surface == b)
            found.push_back(edge);
    return found;
}

int count(const Friends& friends, Continuity continuity)
{
    return static_cast<int>(
        std::count_if(friends.edges().begin(), friends.edges().end(),
                      [&](const FriendEdge& edge) { return edge.continuity == continuity; }));
}

}  // namespace

TEST(Meetings, OneEdgeMeetsSeveralEachOnItsPart)
{
    std::mt19937 random(71);
    const MeetingPair pair = splitSurface(random, {3, 1, true});
    const double cuts[] = {0, 0.7, 2.2, 4};
    std::vector<NurbsSurface> surfaces = {pair.a};
    for (int k = 0; k < 3; ++k)
        surfaces.push_back(retellings()[static_cast<size_t>(2 * k + 1)].tell(
            clampedPart(pair.b, Direction::V, cuts[k], cuts[k + 1])));
    const Friends friends(placed(surfaces));
    for (std::uint32_t k = 0; k < 3; ++k) {
        const auto found = meetingsOf(friends, 0, k + 1);
        ASSERT_EQ(found.size(), 1U) << k;
        EXPECT_EQ(found[0].a.side, Side::endU);
        EXPECT_NEAR(found[0].a.from, cuts[k], 1e-6);
        EXPECT_NEAR(found[0].a.to, cuts[k + 1], 1e-6);
        EXPECT_STREQ(continuityName(found[0].continuity), "G2");
        EXPECT_LE(found[0].gapMax, 1e-9);
    }
    for (const EdgePart& part : friends.nakedEdges())
        EXPECT_FALSE(part.surface == 0 && part.side == Side::endU);
}

TEST(Meetings, WhatNobodyRunsAlongIsNaked)
{
    std::mt19937 random(72);
    const MeetingPair pair = splitSurface(random, {3, 1, false});
    const NurbsSurface part = projectedU(exchanged(clampedPart(pair.b, Direction::V, 1.1, 2.7)), 1.6);
    const Friends friends({{&pair.a}, {&part}});
    ASSERT_EQ(friends.edges().size(), 1U);
    EXPECT_NEAR(friends.edges()[0].a.from, 1.1, 1e-6);
    EXPECT_NEAR(friends.edges()[0].a.to, 2.7, 1e-6);
    EXPECT_EQ(friends.edges()[0].b.from, part.knotsU().domainStart());
    EXPECT_EQ(friends.edges()[0].b.to, part.knotsU().domainEnd());
    std::vector<EdgePart> beside;
    for (const EdgePart& naked : friends.nakedEdges())
        if (naked.surface == 0 && naked.side == Side::endU)
            beside.push_back(naked);
    ASSERT_EQ(beside.size(), 2U);
    EXPECT_EQ(beside[0].from, 0);
    EXPECT_NEAR(beside[0].to, 1.1, 1e-6);
    EXPECT_NEAR(beside[1].from, 2.7, 1e-6);
    EXPECT_EQ(beside[1].to, 4);
    EXPECT_EQ(friends.nakedEdges().size(), 2U + 3U + 3U);
}

// The other edge leaves in the middle, where no knot is and no corner.
TEST(Meetings, EdgesThatPartMeetUpToThere)
{
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const KnotVector three = clampedIntegerKnots(3, 4);
    const auto sheet = [&](double side, double bulge) {
        return surfaceOf(line, three, [&](int i, int j) -> ControlPoint {
            const double y = grevilleAbscissa(three, j);
            return {{side * i + (i == 0 && j >= 5 ? bulge : 0), y, 0}, 1};
        });
    };
    const NurbsSurface a = sheet(-1, 0);
    const NurbsSurface b = sheet(1, 0.5);
    const Friends friends({{&a}, {&b}});
    ASSERT_EQ(friends.edges().size(), 1U);
    const FriendEdge& edge = friends.edges()[0];
    EXPECT_EQ(edge.a.from, 0);
    // Only the last two of seven control points are away: the bulge is 0.5 times the third basis function
    // from the end and those after it, 0.5 (u - 2)^3 / 4 as far as u = 3.
    EXPECT_NEAR(edge.a.to, 2 + std::cbrt(1e-3 * 4 / 0.5), 1e-3);
    EXPECT_STREQ(continuityName(edge.continuity), "G2");
}

TEST(Meetings, ABumpNoHigherThanTheReachIsOneMeetingBeyondTolerance)
{
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const KnotVector three = clampedIntegerKnots(3, 6);
    const auto sheet = [&](double side, double bulge) {
        return surfaceOf(line, three, [&](int i, int j) -> ControlPoint {
            return {{side * i + (i == 0 && j == 4 ? bulge : 0), grevilleAbscissa(three, j), 0}, 1};
        });
    };
    const NurbsSurface a = sheet(-1, 0);
    const NurbsSurface b = sheet(1, 0.003);
    const Friends friends({{&a}, {&b}});
    ASSERT_EQ(friends.edges().size(), 1U);
    EXPECT_STREQ(continuityName(friends.edges()[0].continuity), "none");
    // The basis function is 2/3 at its middle, u = 3.
    EXPECT_NEAR(friends.edges()[0].gapMax, 0.002, 0.00002);
    EXPECT_NEAR(friends.edges()[0].worst, 3, 0.1);
    EXPECT_EQ(friends.nakedEdges().size(), 6U);
}

TEST(Meetings, ASurfaceMeetsItselfAlongItsSeams)
{
    const NurbsSurface ring = torus(Vec3(1, 2, 3), 2, 0.75);
    const Friends friends({{&ring}});
    ASSERT_EQ(friends.edges().size(), 2U);
    EXPECT_EQ(count(friends, Continuity::g2), 2);
    EXPECT_TRUE(friends.nakedEdges().empty());
}

TEST(Meetings, EdgesThatAreAPointAreNeitherMetNorNaked)
{
    const NurbsSurface ball = sphere(Vec3(0), 1);
    const Friends friends({{&ball}});
    ASSERT_EQ(friends.edges().size(), 1U);  // the seam, from pole to pole: the limit of the normals counts
    EXPECT_EQ(count(friends, Continuity::g2), 1);
    EXPECT_TRUE(friends.nakedEdges().empty());

    const NurbsSurface west = clampedPart(ball, Direction::U, 0, 1.3);
    const NurbsSurface east = clampedPart(ball, Direction::U, 1.3, ball.knotsU().domainEnd());
    const Friends halves({{&west}, {&east}});
    EXPECT_EQ(halves.edges().size(), 2U);
    EXPECT_EQ(count(halves, Continuity::g2), 2);
    EXPECT_TRUE(halves.nakedEdges().empty());
}

TEST(Meetings, AnEdgeFoldedOntoItselfMeetsItself)
{
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const KnotVector along = clampedIntegerKnots(1, 4);
    const NurbsSurface folded = surfaceOf(line, along, [](int i, int j) -> ControlPoint {
        const double x[] = {0, 1, 2, 1, 0};
        const double aside[] = {1, 1, 1, -1, -1};
        return {{x[j], i * aside[j], 0}, 1};
    });
    const Friends friends({{&folded}});
    ASSERT_EQ(friends.edges().size(), 1U);
    EXPECT_EQ(friends.edges()[0].a.side, friends.edges()[0].b.side);
    EXPECT_TRUE(friends.edges()[0].reversed);
    EXPECT_EQ(friends.edges()[0].a.from, 0);
    EXPECT_EQ(friends.edges()[0].a.to, 2);
}

TEST(Meetings, OfKnotAllEdgesMeetSmoothly)
{
    const Scene scene = findSample("knot")->make();
    const Friends friends(placed(scene));
    EXPECT_EQ(friends.edges().size(), 1200U);
    EXPECT_EQ(count(friends, Continuity::g2), 1200);
    EXPECT_TRUE(friends.nakedEdges().empty());
}

// Surfaces 0, 2, 4 are starboard, 1, 3, 5 port, from aft. They are cut from one surface; between the halves
// lies the crease: keel and stem.
TEST(Meetings, OfHullTheCreaseIsFoundAndNothingElse)
{
    const Scene scene = findSample("hull")->make();
    const Friends friends(placed(scene));
    int creases = 0;
    for (const FriendEdge& edge : friends.edges()) {
        const bool acrossKeel = edge.a.surface % 2 != edge.b.surface % 2;
        EXPECT_STREQ(continuityName(edge.continuity), acrossKeel ? "G0" : "G2");
        creases += acrossKeel ? 1 : 0;
    }
    EXPECT_EQ(creases, 4);
    EXPECT_EQ(friends.edges().size(), 8U);
    EXPECT_EQ(friends.nakedEdges().size(), 8U);  // six pieces of deck, two of the transom
}

}  // namespace knotspan::testing
