// Keep friends where the rows of the two sides go with each other, more or less.
#include <cmath>

#include <gtest/gtest.h>

#include "model/geometry/knot_insertion.h"
#include "tests/model/matching/friend_model.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

using testing::FriendModel;

// Two surfaces that share the straight edge x = 0 from y = 0 to 10, by control points of their own; b stands
// up where it is not to run on.
struct StraightPair {
    std::vector<double> placesA{0, 5, 10};
    std::vector<double> placesB{0, 5, 10};
    std::vector<double> weightsB{1, 1, 1};
    bool runsOn = true;
    double size = 1;

    [[nodiscard]] FriendModel model() const
    {
        const KnotVector knots = KnotVector::clampedUniform(2, 1);
        std::vector<ControlPoint> a;
        std::vector<ControlPoint> b;
        for (int i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) {
                a.push_back({size * Vec3(-i, placesA[j], 0), 1});
                b.push_back({size * (runsOn ? Vec3(i, placesB[j], 0) : Vec3(0, placesB[j], i)), weightsB[j]});
            }
        FriendModel model;
        model.surfaces = {NurbsSurface::create(knots, knots, a).value(),
                          NurbsSurface::create(knots, knots, b).value()};
        model.findEdges();
        return model;
    }
};

PointMove pulled(const FriendModel& model, std::uint32_t surface, ControlPointIndex index, const Vec3& way)
{
    PointMove pull{surface, index, {}};
    pull.position = model.pointAt(pull) + way;
    return pull;
}

// Such an edge is closed, and G2, but only where its control points are.
TEST(KeepFriends, RefusesEdgesWhoseControlPointsDoNotGoWithEachOther)
{
    const StraightPair elsewhere{.placesB = {0, 4, 10}};
    const StraightPair heavier{.weightsB = {1, 1.5, 1}};
    // A projective change of parameter: weights that rise by one factor from point to point.
    const StraightPair faster{.weightsB = {1, 2, 4}};
    for (StraightPair pair : {elsewhere, heavier, faster})
        for (const bool runsOn : {true, false}) {
            pair.runsOn = runsOn;
            const FriendModel model = pair.model();
            ASSERT_EQ(model.edges.size(), 1u);
            EXPECT_EQ(model.edges[0].continuity, runsOn ? Continuity::g2 : Continuity::g0);
            for (const std::uint32_t surface : {0U, 1U}) {
                const auto moves = model.keeper().follow({pulled(model, surface, {0, 1}, {0, 0, 2})});
                ASSERT_FALSE(moves);
                EXPECT_NE(moves.error().sentence().find("along it"), std::string::npos)
                    << moves.error().sentence();
                // The row behind it shapes the edge only where that is smooth.
                EXPECT_EQ(model.keeper().follow({pulled(model, surface, {1, 1}, {0, 0, 2})}).has_value(),
                          !runsOn);
                EXPECT_TRUE(model.keeper().follow({pulled(model, surface, {2, 1}, {0, 0, 2})}));
            }
        }
}

// Whatever the sides' control points are: what is pulled either is refused or stays as smooth as it was.
TEST(KeepFriends, OpensNoEdgeWhoseControlPointsDoNotAgree)
{
    std::mt19937 random(106);
    int refused = 0;
    int followed = 0;
    for (int round = 0; round < 400; ++round) {
        StraightPair pair;
        pair.runsOn = round % 2 == 0;
        // Edges as long as a hundred gap tolerances, and as ten thousand.
        pair.size = round % 4 < 2 ? 1 : 0.01;
        // From a hundredth of the gap tolerance to a hundred of it.
        pair.placesB[1] += std::pow(10, testing::randomBetween(random, -5, -1)) / pair.size;
        if (round % 5 == 0)
            pair.weightsB[1] += std::pow(10, testing::randomBetween(random, -12, -3));
        FriendModel model = pair.model();
        ASSERT_EQ(model.edges.size(), 1u);
        const Continuity before = std::min(model.edges[0].continuity, Continuity::g1);
        const Vec3 way{testing::randomBetween(random, -1, 1), 0, testing::randomBetween(random, -20, 20)};
        const ControlPointIndex index{round % 3 == 0 ? 1 : 0, 1};
        const auto moves = model.keeper().follow({pulled(model, 0, index, pair.size * way)});
        ++(moves ? followed : refused);
        if (!moves)
            continue;
        model.apply(*moves);
        model.findEdges();
        ASSERT_EQ(model.edges.size(), 1u) << round;
        EXPECT_GE(smoothnessRank(model.edges[0].continuity), smoothnessRank(before))
            << round << ' ' << model.edges[0].angleBoundDeg << " degrees";
        EXPECT_LE(model.edges[0].gapMax, 1.01e-3);
    }
    EXPECT_GT(refused, 50);
    EXPECT_GT(followed, 50);
    RecordProperty("followed", followed);
}

// One surface cut at a knot next to which others lie: rows as close to the edge as those knots are to it.
TEST(KeepFriends, FollowsHoweverCloseTheRowsAre)
{
    for (const double near : {1e-1, 1e-3, 1e-4, 1e-5, 1e-6}) {
        const KnotVector u = KnotVector::create(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}).value();
        const KnotVector v = KnotVector::clampedUniform(3, 2);
        std::vector<ControlPoint> points;
        for (int i = 0; i < u.controlPointCount(); ++i)
            for (int j = 0; j < v.controlPointCount(); ++j)
                points.push_back({{i, 10.0 * j + 0.3 * i, std::sin(i + 0.5 * j)}, 1});
        const NurbsSurface whole =
            withKnotsInserted(NurbsSurface::create(u, v, points).value(), Direction::U, {1 - near, 1 + near});
        FriendModel model;
        model.surfaces = {clampedPart(whole, Direction::U, 0, 1), clampedPart(whole, Direction::U, 1, 2)};
        model.findEdges();
        ASSERT_EQ(model.edges.size(), 1u);
        ASSERT_TRUE(model.edges[0].areFriends());
        const auto moves =
            model.keeper().follow({pulled(model, 0, {model.surfaces[0].countU() - 1, 2}, {0, 0, 0.1})});
        ASSERT_TRUE(moves) << near << ' ' << moves.error().sentence();
        model.apply(*moves);
        model.findEdges();
        ASSERT_EQ(model.edges.size(), 1u);
        EXPECT_TRUE(model.edges[0].areFriends()) << near << ' ' << model.edges[0].angleBoundDeg;
    }
}

// A twentieth of a thousandth of the distance between the rows, in any unit.
TEST(KeepFriends, MeasuresByTheModelHowWellRowsKeepTheirProportion)
{
    for (const double size : {1e-2, 1.0, 1e3}) {
        const StraightPair pair{.size = size};
        for (const double lift : {5e-5, 2e-4}) {
            FriendModel model = pair.model();
            model.apply({pulled(model, 1, {1, 1}, size * Vec3(0, 0, lift))});
            model.edges.clear();
            model.join(0, Side::startU, 1, Side::startU);
            EXPECT_EQ(model.keeper().follow({pulled(model, 0, {1, 1}, size * Vec3(0, 0, 1))}).has_value(),
                      lift < 1e-4)
                << size << ' ' << lift;
        }
    }
}

// b is longer than a by half the gap tolerance, so Friends leaves its end out.
TEST(KeepFriends, FollowsAlongWholeEdgesWhoseCornersMissEachOtherByLessThanTheGap)
{
    FriendModel model = StraightPair{.placesB = {0, 5.00025, 10.0005}}.model();
    ASSERT_EQ(model.edges.size(), 1u);
    ASSERT_LT(model.edges[0].b.to, 1);
    const auto moves = model.keeper().follow({pulled(model, 0, {0, 1}, {0, 0, 2})});
    ASSERT_TRUE(moves) << moves.error().sentence();
    model.apply(*moves);
    model.findEdges();
    ASSERT_EQ(model.edges.size(), 1u);
    EXPECT_TRUE(model.edges[0].areFriends());
}

}  // namespace
}  // namespace knotspan
