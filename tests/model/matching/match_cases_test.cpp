#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "tests/model/matching/matching_pairs.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

using testing::applied;
using testing::BrokenPair;
using testing::expectOnlyNamedRowsMoved;
using testing::MeasuredFit;

BrokenPair anyPair(int seed, const testing::PairShape& shape = {})
{
    std::mt19937 random(static_cast<unsigned>(seed));
    return testing::brokenPair(random, shape);
}

TEST(Match, ClosesAGapWithOneRow)
{
    const BrokenPair pair = anyPair(1, {.gap = 0.2});
    const auto proposal = matchEdge(pair.request(Continuity::g0, MatchSides::b));
    ASSERT_TRUE(proposal) << proposal.error().sentence();
    EXPECT_FALSE(proposal->a);
    EXPECT_EQ(expectOnlyNamedRowsMoved(pair.b, *proposal->b), 1);
    EXPECT_EQ(proposal->b->firstRow, 0);
    EXPECT_LE(testing::measuredFit(applied(pair, *proposal), 500).gap, 1e-13);
    EXPECT_GT(proposal->b->moved, 0.19);
    EXPECT_LT(proposal->b->moved, 0.4);
}

TEST(Match, NamesRowsFromTheEndWhereTheEdgeIsThere)
{
    const BrokenPair pair = anyPair(2, {.sideB = Side::endV});
    const auto proposal = matchEdge(pair.request(Continuity::g1, MatchSides::b));
    ASSERT_TRUE(proposal) << proposal.error().sentence();
    const MatchedSurface& matched = *proposal->b;
    EXPECT_EQ(matched.across, Direction::V);
    EXPECT_EQ(matched.lastRow, matched.surface.countV() - 1);
    EXPECT_EQ(matched.firstRow, matched.surface.countV() - 2);
}

// Moved, turned, scaled and mirrored in the model, each in its own way.
TEST(Match, WorksBetweenSurfacesThatArePlaced)
{
    BrokenPair pair = anyPair(3, {.rationalB = true, .gap = 0.05});
    const auto into = [](const NurbsSurface& surface, const Mat4& transform) {
        std::vector<ControlPoint> points = surface.controlPoints();
        for (ControlPoint& point : points)
            point.position = transformed(point.position, transform);
        return NurbsSurface::create(surface.knotsU(), surface.knotsV(), points).value();
    };
    Mat4 placeA = glm::rotate(glm::translate(Mat4(1.0), Vec3(30, -7, 2)), 0.7, Vec3(1, 2, 3));
    Mat4 placeB = glm::scale(glm::rotate(Mat4(1.0), -1.1, Vec3(0, 1, 1)), Vec3(2, -3, 0.5));
    BrokenPair own = pair;
    own.a = into(pair.a, glm::inverse(placeA));
    own.b = into(pair.b, glm::inverse(placeB));
    for (const MatchSides move : {MatchSides::a, MatchSides::b, MatchSides::both}) {
        MatchRequest request = own.request(Continuity::g1, move);
        request.a.transform = placeA;
        request.b.transform = placeB;
        const auto proposal = matchEdge(request);
        ASSERT_TRUE(proposal) << proposal.error().sentence();
        const BrokenPair mended = applied(own, *proposal);
        BrokenPair inModel = pair;
        inModel.a = into(mended.a, placeA);
        inModel.b = into(mended.b, placeB);
        const MeasuredFit fit = testing::measuredFit(inModel, 500);
        EXPECT_LE(fit.angleDeg, 0.01);
        EXPECT_TRUE(fit.runsOn);
        EXPECT_LE(fit.gap, 1e-12);
        EXPECT_NEAR(fit.angleDeg, proposal->angleDeg, 0.3 * proposal->angleDeg);
    }
}

// One surface cut in two.
BrokenPair smoothPair(int seed, int degree, bool rational = false)
{
    std::mt19937 random(static_cast<unsigned>(seed));
    const KnotVector knots = KnotVector::clampedUniform(degree, 6);
    std::vector<ControlPoint> points;
    for (int i = 0; i < knots.controlPointCount(); ++i)
        for (int j = 0; j < knots.controlPointCount(); ++j)
            points.push_back({{i, j, std::sin(0.5 * i + 0.7 * j)},
                              rational ? testing::randomBetween(random, 0.7, 1.4) : 1});
    const NurbsSurface whole = NurbsSurface::create(knots, knots, points).value();
    const NurbsSurface a = clampedPart(whole, Direction::U, 0, 0.5);
    const NurbsSurface b = clampedPart(whole, Direction::U, 0.5, 1);
    return {a, b, {0, Side::endU, 0, 1}, {1, Side::startU, 0, 1}, false};
}

TEST(Match, LeavesWhatIsSmoothAlready)
{
    for (const bool rational : {false, true}) {
        const BrokenPair pair = smoothPair(4, 3, rational);
        const auto proposal = matchEdge(pair.request(Continuity::g2, MatchSides::b));
        ASSERT_TRUE(proposal) << proposal.error().sentence();
        EXPECT_EQ(proposal->b->surface, pair.b);
        EXPECT_LT(proposal->b->lastRow, proposal->b->firstRow);
        EXPECT_EQ(proposal->b->moved, 0);
        EXPECT_EQ(proposal->b->movedMost, 0);
    }
}

TEST(Match, MovesTheThirdRowAloneWhereOnlyCurvaturesDiffer)
{
    BrokenPair pair = smoothPair(5, 3);
    std::vector<ControlPoint> points = pair.b.controlPoints();
    for (int j = 0; j < pair.b.countV(); ++j)
        points[static_cast<size_t>(2 * pair.b.countV() + j)].position.z += 0.3;
    pair.b = NurbsSurface::create(pair.b.knotsU(), pair.b.knotsV(), points).value();
    ASSERT_GT(testing::measuredFit(pair, 100).curvature, 0.1);
    const auto proposal = matchEdge(pair.request(Continuity::g2, MatchSides::b));
    ASSERT_TRUE(proposal) << proposal.error().sentence();
    EXPECT_EQ(proposal->b->firstRow, 2);
    EXPECT_EQ(proposal->b->lastRow, 2);
    EXPECT_LE(testing::measuredFit(applied(pair, *proposal), 500).curvature, 0.01);
}

TEST(Match, MeetsAPartOfALongerEdgeButDoesNotMoveThatOne)
{
    std::mt19937 random(6);
    BrokenPair pair = testing::brokenPair(random, {.spansA = 6});
    const KnotVector& along = pair.b.knotsV();
    const double from = 0.2 * along.domainEnd();
    const double to = 0.7 * along.domainEnd();
    pair.b = clampedPart(pair.b, Direction::V, from, to);
    pair.edgeB = {1, Side::startU, from, to};
    pair.edgeA.from = 0.2 * pair.edgeA.to;
    pair.edgeA.to = 0.7 * pair.edgeA.to;
    const auto proposal = matchEdge(pair.request(Continuity::g1, MatchSides::b));
    ASSERT_TRUE(proposal) << proposal.error().sentence();
    const MeasuredFit fit = testing::measuredFit(applied(pair, *proposal), 500);
    EXPECT_LE(fit.angleDeg, 0.01);
    EXPECT_TRUE(fit.runsOn);
    EXPECT_LE(fit.gap, 1e-12);
    for (const MatchSides move : {MatchSides::a, MatchSides::both}) {
        const auto refused = matchEdge(pair.request(Continuity::g1, move));
        ASSERT_FALSE(refused);
        EXPECT_NE(refused.error().sentence().find("Only a part of the edge"), std::string::npos);
    }
}

// b's edge is longer than a's by half the gap tolerance, so Friends leaves its end out.
TEST(Match, MovesWholeEdgesWhoseCornersMissEachOtherByLessThanTheGap)
{
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const auto sheet = [&](double width, double length, double rise) {
        return NurbsSurface::create(
                   line, line,
                   {{{0, 0, 0}, 1}, {{0, length, 0}, 1}, {{width, 0, rise}, 1}, {{width, length, rise}, 1}})
            .value();
    };
    for (const double scale : {1.0, 1000.0}) {
        const NurbsSurface a = sheet(-scale, 10 * scale, 0);
        const NurbsSurface b = sheet(scale, 10 * scale + 0.0005, 0.2 * scale);
        const Friends friends({{&a}, {&b}});
        ASSERT_EQ(friends.edges().size(), 1u);
        const FriendEdge& edge = friends.edges()[0];
        ASSERT_LT(edge.b.to, 1);
        const BrokenPair pair{a, b, edge.a, edge.b, edge.reversed};
        for (const MatchSides move : {MatchSides::a, MatchSides::b, MatchSides::both}) {
            const auto proposal = matchEdge(pair.request(Continuity::g1, move));
            ASSERT_TRUE(proposal) << proposal.error().sentence();
            const BrokenPair mended = applied(pair, *proposal);
            const Friends after({{&mended.a}, {&mended.b}}, {1e-3, 0.01, 0.01});
            ASSERT_EQ(after.edges().size(), 1u);
            EXPECT_TRUE(after.edges()[0].areFriends());
            EXPECT_EQ(after.edges()[0].b.to, 1);
        }
    }
    // What is left out is longer than the gap.
    const NurbsSurface a = sheet(-1, 10, 0);
    const NurbsSurface b = sheet(1, 10.002, 0.2);
    const Friends friends({{&a}, {&b}});
    ASSERT_EQ(friends.edges().size(), 1u);
    const BrokenPair pair{a, b, friends.edges()[0].a, friends.edges()[0].b, false};
    const auto refused = matchEdge(pair.request(Continuity::g1, MatchSides::b));
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("Only a part of the edge"), std::string::npos);
}

// Two flat sheets that meet at the given angle, 0 where they run on.
BrokenPair hinge(double angleDeg)
{
    const KnotVector line = KnotVector::clampedUniform(1, 1);
    const double angle = angleDeg * 3.14159265358979 / 180;
    const Vec3 away{3 * std::cos(angle), 0, 3 * std::sin(angle)};
    const Vec3 end{0, 4, 0};
    return {
        NurbsSurface::create(line, line, {{Vec3(-3, 0, 0), 1}, {Vec3(-3, 4, 0), 1}, {Vec3(0), 1}, {end, 1}})
            .value(),
        NurbsSurface::create(line, line, {{Vec3(0), 1}, {end, 1}, {away, 1}, {away + end, 1}}).value(),
        {0, Side::endU, 0, 1},
        {1, Side::startU, 0, 1},
        false};
}

TEST(Match, SaysAtWhichAngleSurfacesMeetThatItDoesNotMatch)
{
    for (const double angle : {89.0, -89.0}) {
        const BrokenPair pair = hinge(angle);
        const auto proposal = matchEdge(pair.request(Continuity::g1, MatchSides::b));
        ASSERT_TRUE(proposal) << proposal.error().sentence();
        const MeasuredFit fit = testing::measuredFit(applied(pair, *proposal), 100);
        EXPECT_LE(fit.angleDeg, 0.01);
        EXPECT_TRUE(fit.runsOn);
    }
    const auto proposal = matchEdge(hinge(95.8).request(Continuity::g1, MatchSides::b));
    ASSERT_FALSE(proposal);
    EXPECT_NE(proposal.error().sentence().find("meet at 95.8 degrees"), std::string::npos)
        << proposal.error().sentence();
    EXPECT_NE(proposal.error().sentence().find("only those that meet at less than 90 are matched"),
              std::string::npos);
}

TEST(Match, RefusesSurfacesThatFoldBackAndPoles)
{
    BrokenPair folded = smoothPair(7, 3);
    folded.b = folded.a;
    folded.edgeB = {1, Side::endU, 0, 1};
    const auto back = matchEdge(folded.request(Continuity::g1, MatchSides::b));
    ASSERT_FALSE(back);
    EXPECT_NE(back.error().sentence().find("fold back"), std::string::npos);
    EXPECT_TRUE(matchEdge(folded.request(Continuity::g0, MatchSides::b)));

    BrokenPair pole = smoothPair(8, 3);
    for (NurbsSurface* surface : {&pole.a, &pole.b}) {
        std::vector<ControlPoint> points = surface->controlPoints();
        const int row = surface == &pole.a ? surface->countU() - 1 : 0;
        for (int j = 0; j < surface->countV(); ++j)
            points[static_cast<size_t>(row * surface->countV() + j)].position = Vec3(3, 4, 0);
        *surface = NurbsSurface::create(surface->knotsU(), surface->knotsV(), points).value();
    }
    const auto atPole = matchEdge(pole.request(Continuity::g1, MatchSides::b));
    ASSERT_FALSE(atPole);
    EXPECT_NE(atPole.error().sentence().find("no tangent plane"), std::string::npos);
}

// A projective change of parameter: the same curve, but no affine map leads from one to the other.
TEST(Match, LeavesAnEdgeWhereItIsThatRunsAlongOneParametrizedOtherwise)
{
    BrokenPair pair = smoothPair(9, 3);
    pair.a = clampedPart(pair.a, Direction::V, 0, 1.0 / 6);
    pair.b = clampedPart(pair.b, Direction::V, 0, 1.0 / 6);
    pair.edgeA.to = pair.edgeB.to = 1.0 / 6;
    std::vector<ControlPoint> points = pair.b.controlPoints();
    for (int i = 0; i < pair.b.countU(); ++i)
        for (int j = 0; j < pair.b.countV(); ++j) {
            ControlPoint& point = points[static_cast<size_t>(i * pair.b.countV() + j)];
            point.weight *= std::pow(1.7, j);
            point.position.z += 0.08 * (point.position.x - 3);
        }
    for (int j = 0; j < pair.b.countV(); ++j)
        points[static_cast<size_t>(j)].position = pair.b.controlPoint(0, j).position;
    pair.b = NurbsSurface::create(pair.b.knotsU(), pair.b.knotsV(), points).value();
    const auto proposal = matchEdge(pair.request(Continuity::g1, MatchSides::b));
    ASSERT_TRUE(proposal) << proposal.error().sentence();
    EXPECT_EQ(proposal->b->firstRow, 1);
    EXPECT_EQ(proposal->b->lastRow, 1);
    EXPECT_LE(proposal->gap, 1e-9);
    EXPECT_LE(proposal->angleDeg, 0.01);
}

TEST(Match, MendsASeamOnOneSide)
{
    const KnotVector around = KnotVector::clampedUniform(3, 8);
    const KnotVector along = KnotVector::clampedUniform(2, 3);
    const NurbsSurface tube = [&] {
        std::vector<ControlPoint> points;
        for (int i = 0; i < around.controlPointCount(); ++i)
            for (int j = 0; j < along.controlPointCount(); ++j) {
                const double angle = 2 * 3.14159265358979 * i / (around.controlPointCount() - 1);
                points.push_back(
                    {{(2 + 0.1 * j) * std::cos(angle),
                      (i == around.controlPointCount() - 1 ? 0.0 : (2 + 0.1 * j)) * std::sin(angle), j},
                     1});
            }
        return NurbsSurface::create(around, along, points).value();
    }();
    BrokenPair pair{tube, tube, {0, Side::endU, 0, 1}, {0, Side::startU, 0, 1}, false};
    ASSERT_GT(testing::measuredFit(pair, 100).angleDeg, 1);
    const auto refused = matchEdge(pair.request(Continuity::g1, MatchSides::both));
    EXPECT_FALSE(refused);
    const auto proposal = matchEdge(pair.request(Continuity::g1, MatchSides::b));
    ASSERT_TRUE(proposal) << proposal.error().sentence();
    pair.a = pair.b = proposal->b->surface;
    EXPECT_LE(testing::measuredFit(pair, 500).angleDeg, 0.01);
}

TEST(Match, RaisesTheDegreeOfARuledSurfaceSoThatItsOtherEdgeStays)
{
    const BrokenPair pair = anyPair(10, {.acrossB = 3});
    const std::vector<ControlPoint> net = [&] {
        std::vector<ControlPoint> points;
        for (const int row : {0, pair.b.countU() - 1})
            for (int j = 0; j < pair.b.countV(); ++j)
                points.push_back(pair.b.controlPoint(row, j));
        return points;
    }();
    BrokenPair ruled = pair;
    ruled.b = NurbsSurface::create(KnotVector::clampedUniform(1, 1), pair.b.knotsV(), net).value();
    ruled.edgeB = {1, Side::startU, pair.edgeB.from, pair.edgeB.to};
    const auto proposal = matchEdge(ruled.request(Continuity::g2, MatchSides::b));
    ASSERT_TRUE(proposal) << proposal.error().sentence();
    EXPECT_EQ(proposal->b->surface.degreeU(), 3);
    EXPECT_LE(expectOnlyNamedRowsMoved(ruled.b, *proposal->b), 3);
    EXPECT_LE(proposal->b->lastRow, 2);
    EXPECT_LE(testing::measuredFit(applied(ruled, *proposal), 500).curvature, 0.01);
}

// Lines across the edge that lean one way on one side and the other way on the other.
TEST(Match, SaysWhyCurvaturesThatJumpCannotBeMet)
{
    const auto leaning = [](int degreeAlong, double lean, double x0) {
        const KnotVector u = KnotVector::clampedUniform(3, 2);
        const KnotVector v = KnotVector::clampedUniform(degreeAlong, 4);
        std::vector<ControlPoint> points;
        for (int i = 0; i < u.controlPointCount(); ++i)
            for (int j = 0; j < v.controlPointCount(); ++j) {
                const double y = 6.0 * j / (v.controlPointCount() - 1);
                const double x = x0 + i;
                points.push_back({{x, y + lean * x, std::sin(1.5 * y) + 0.05 * x * x}, 1});
            }
        return NurbsSurface::create(u, v, points).value();
    };
    const BrokenPair pair{
        leaning(2, 0.8, -4), leaning(3, -0.8, 0), {0, Side::endU, 0, 1}, {1, Side::startU, 0, 1}, false};
    EXPECT_TRUE(matchEdge(pair.request(Continuity::g1, MatchSides::b)));
    const auto proposal = matchEdge(pair.request(Continuity::g2, MatchSides::b));
    ASSERT_FALSE(proposal);
    EXPECT_NE(proposal.error().sentence().find("jumps along the edge"), std::string::npos)
        << proposal.error().sentence();
}

}  // namespace
}  // namespace knotspan
