#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/model/matching/matching_pairs.h"

namespace knotspan {
namespace {

using testing::applied;
using testing::BrokenPair;
using testing::expectOnlyNamedRowsMoved;
using testing::MeasuredFit;

TEST(Match, MendsRandomBreaksOfFiveDegreesToAHundredth)
{
    std::mt19937 random(91);
    int knots = 0;
    for (int k = 0; k < 60; ++k) {
        const testing::PairShape shape = testing::randomShape(random);
        const BrokenPair pair = testing::brokenPair(random, shape);
        const MatchSides move = static_cast<MatchSides>(k % 3);
        SCOPED_TRACE("pair " + std::to_string(k));
        ASSERT_GT(testing::measuredFit(pair, 200).angleDeg, 2);
        const auto proposal = matchEdge(pair.request(Continuity::g1, move));
        ASSERT_TRUE(proposal) << proposal.error().sentence();
        EXPECT_EQ(proposal->a.has_value(), move != MatchSides::b);
        EXPECT_EQ(proposal->b.has_value(), move != MatchSides::a);
        const BrokenPair mended = applied(pair, *proposal);
        const MeasuredFit fit = testing::measuredFit(mended, 1000);
        EXPECT_LE(fit.angleDeg, 0.01);
        EXPECT_LE(fit.gap, 1e-12);
        EXPECT_TRUE(fit.runsOn);
        if (proposal->a) {
            EXPECT_LE(expectOnlyNamedRowsMoved(pair.a, *proposal->a), 2);
        }
        if (proposal->b) {
            EXPECT_LE(expectOnlyNamedRowsMoved(pair.b, *proposal->b), 2);
            knots += proposal->b->surface.countU() * proposal->b->surface.countV() -
                     pair.b.countU() * pair.b.countV();
        }
    }
    RecordProperty("control_points_added", knots);
}

TEST(Match, MakesCurvaturesAgree)
{
    std::mt19937 random(92);
    for (int k = 0; k < 30; ++k) {
        // Of degree 2 along the edge, a surface would have jumps of curvature along it.
        testing::PairShape shape = testing::randomShape(random);
        shape.degreeA = std::max(shape.degreeA, 3);
        shape.degreeB = std::max(shape.degreeB, 3);
        const BrokenPair pair = testing::brokenPair(random, shape);
        const MatchSides move = static_cast<MatchSides>(k % 3);
        SCOPED_TRACE("pair " + std::to_string(k));
        const auto proposal = matchEdge(pair.request(Continuity::g2, move));
        ASSERT_TRUE(proposal) << proposal.error().sentence();
        const MeasuredFit fit = testing::measuredFit(applied(pair, *proposal), 1000);
        EXPECT_LE(fit.angleDeg, 0.01);
        EXPECT_TRUE(fit.runsOn);
        EXPECT_LE(fit.curvature, 0.01);
        EXPECT_LE(fit.gap, 1e-12);
        if (proposal->b) {
            EXPECT_LE(expectOnlyNamedRowsMoved(pair.b, *proposal->b), 3);
        }
    }
}

TEST(Match, MakesWhatFriendsCallsG1AndG2WithCertainty)
{
    std::mt19937 random(93);
    for (int k = 0; k < 20; ++k) {
        testing::PairShape shape = testing::randomShape(random);
        shape.degreeA = std::max(shape.degreeA, 3);
        shape.degreeB = std::max(shape.degreeB, 3);
        const BrokenPair pair = testing::brokenPair(random, shape);
        for (const Continuity wanted : {Continuity::g1, Continuity::g2}) {
            SCOPED_TRACE(std::to_string(k) + ' ' + continuityName(wanted));
            const auto proposal = matchEdge(pair.request(wanted, static_cast<MatchSides>(k % 3)));
            ASSERT_TRUE(proposal) << proposal.error().sentence();
            const BrokenPair mended = applied(pair, *proposal);
            const Friends friends({{&mended.a}, {&mended.b}}, {1e-3, 0.01, 0.01});
            ASSERT_EQ(friends.edges().size(), 1u);
            EXPECT_GE(friends.edges()[0].continuity, wanted);
            EXPECT_TRUE(friends.edges()[0].areFriends())
                << continuityName(friends.edges()[0].continuity) << ' ' << friends.edges()[0].angleBoundDeg;
            EXPECT_EQ(friends.edges()[0].reversed, pair.reversed);
        }
    }
}

}  // namespace
}  // namespace knotspan
