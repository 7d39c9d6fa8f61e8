#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/geometry/orientation.h"
#include "model/samples/samples.h"
#include "tests/model/matching/friend_model.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

using testing::EdgeBreak;
using testing::FriendModel;

FriendModel knot()
{
    FriendModel model;
    const Scene scene = makeKnot();
    for (const auto& [id, object] : scene.objects())
        model.surfaces.push_back(object->surface);
    for (size_t along = 0; along < 50; ++along)
        for (size_t round = 0; round < 12; ++round) {
            const size_t here = along * 12 + round;
            model.join(here, Side::endU, along * 12 + (round + 1) % 12, Side::startU);
            model.join(here, Side::endV, (along + 1) % 50 * 12 + round, Side::startV);
        }
    return model;
}

PointMove anyPull(std::mt19937& random, const FriendModel& model, double far)
{
    const auto whole = [&](int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); };
    PointMove pull;
    pull.surface = static_cast<std::uint32_t>(whole(static_cast<int>(model.surfaces.size())));
    pull.index = {whole(model.surfaces[pull.surface].countU()), whole(model.surfaces[pull.surface].countV())};
    pull.position = model.pointAt(pull);
    for (int axis = 0; axis < 3; ++axis)
        pull.position[axis] += testing::randomBetween(random, -far, far);
    return pull;
}

TEST(KeepFriends, KeepsEveryTouchedEdgeOfTheKnotThroughAThousandDrags)
{
    std::mt19937 random(101);
    FriendModel model = knot();
    size_t touched = 0;
    double worst = 0;
    double gap = 0;
    for (int drag = 0; drag < 1000; ++drag) {
        const FriendKeeper keeper = model.keeper();
        const PointMove pull = anyPull(random, model, 0.04);
        const auto moves = keeper.follow({pull});
        ASSERT_TRUE(moves) << moves.error().sentence();
        ASSERT_LE(moves->size(), 16u);
        model.apply(*moves);
        EXPECT_EQ(model.pointAt(pull), pull.position);
        for (const size_t edge : keeper.touchedEdges(*moves)) {
            const EdgeBreak now = breakOf(model, model.edges[edge]);
            EXPECT_TRUE(now.runsOn) << "drag " << drag;
            worst = std::max(worst, now.angleDeg);
            gap = std::max(gap, now.gap);
            ++touched;
        }
    }
    EXPECT_GT(touched, 1000u);
    EXPECT_LE(worst, 0.1);
    EXPECT_LE(gap, 1e-12);
    RecordProperty("worst_angle_deg", std::to_string(worst));
}

// Friend edges stay smooth and none that was closed opens.
void expectKept(const FriendModel& model, const std::string& after)
{
    for (const FriendEdge& edge : model.edges) {
        if (edge.continuity == Continuity::none)
            continue;
        const EdgeBreak now = breakOf(model, edge);
        EXPECT_LE(now.gap, 1e-12) << after;
        if (edge.areFriends()) {
            EXPECT_LE(now.angleDeg, 1e-6) << after;
            EXPECT_TRUE(now.runsOn) << after;
        }
    }
}

TEST(KeepFriends, KeepsTheHullSmoothAndItsCreaseClosed)
{
    std::mt19937 random(102);
    FriendModel model;
    const Scene scene = makeHull();
    for (const auto& [id, object] : scene.objects())
        model.surfaces.push_back(object->surface);
    model.findEdges();
    const auto count = [&](auto is) { return std::count_if(model.edges.begin(), model.edges.end(), is); };
    ASSERT_EQ(count([](const FriendEdge& edge) { return edge.areFriends(); }), 4);
    ASSERT_GE(count([](const FriendEdge& edge) { return edge.continuity == Continuity::g0; }), 3);
    int refused = 0;
    for (int drag = 0; drag < 100; ++drag) {
        const PointMove pull = anyPull(random, model, 0.1);
        const auto moves = model.keeper().follow({pull});
        if (!moves) {
            ++refused;
            continue;
        }
        model.apply(*moves);
        expectKept(model, "after drag " + std::to_string(drag));
    }
    EXPECT_EQ(refused, 0);
}

// One rational surface cut in 3 x 3, the parts turned, exchanged and placed at random.
FriendModel ninePieces(std::mt19937& random)
{
    const KnotVector knots =
        KnotVector::create(4, {0, 0, 0, 0, 0, 1, 2, 2.5, 3, 4, 5, 6, 6, 6, 6, 6}).value();
    std::vector<ControlPoint> points;
    for (int i = 0; i < knots.controlPointCount(); ++i)
        for (int j = 0; j < knots.controlPointCount(); ++j)
            points.push_back({{i, j + 0.2 * i, std::sin(0.8 * i) * std::cos(0.5 * j)},
                              testing::randomBetween(random, 0.8, 1.25)});
    const NurbsSurface whole = NurbsSurface::create(knots, knots, points).value();
    FriendModel model;
    const auto chance = [&] { return testing::randomBetween(random, 0, 1) < 0.5; };
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            NurbsSurface piece = clampedPart(clampedPart(whole, Direction::U, 2 * a, 2 * a + 2), Direction::V,
                                             2 * b, 2 * b + 2);
            if (chance())
                piece = reversed(piece, Direction::U);
            if (chance())
                piece = reversed(piece, Direction::V);
            if (chance())
                piece = swapped(piece);
            Mat4 place(1.0);
            if (chance()) {
                place = glm::rotate(glm::scale(glm::translate(place, Vec3(a, -b, 1)), Vec3(1, -2, 1.5)),
                                    0.3 + a, Vec3(b, 1, 1));
                std::vector<ControlPoint> moved = piece.controlPoints();
                for (ControlPoint& point : moved)
                    point.position = transformed(point.position, glm::inverse(place));
                piece = NurbsSurface::create(piece.knotsU(), piece.knotsV(), moved).value();
            }
            model.surfaces.push_back(piece);
            model.transforms.push_back(place);
        }
    return model;
}

TEST(KeepFriends, FollowsFromAnySideOfSurfacesThatAreTurnedPlacedAndRational)
{
    std::mt19937 random(103);
    for (int round = 0; round < 5; ++round) {
        FriendModel model = ninePieces(random);
        model.findEdges();
        ASSERT_EQ(model.edges.size(), 12u);
        for (int drag = 0; drag < 40; ++drag) {
            const PointMove pull = anyPull(random, model, 0.15);
            const auto moves = model.keeper().follow({pull});
            ASSERT_TRUE(moves) << moves.error().sentence();
            model.apply(*moves);
            expectKept(model, "after drag " + std::to_string(drag));
        }
    }
}

TEST(KeepFriends, LeavesEdgesInPlaceUnlessTheyArePulled)
{
    std::mt19937 random(104);
    FriendModel model = knot();
    const FriendKeeper keeper = model.keeper();
    PointMove pull;
    pull.surface = 30;
    pull.index = {1, 4};  // behind the edge u = start
    pull.position = model.pointAt(pull) + Vec3(0.01, 0.02, -0.01);
    const auto moves = keeper.follow({pull});
    ASSERT_TRUE(moves);
    ASSERT_EQ(moves->size(), 2u);
    EXPECT_EQ((*moves)[0].surface, 29u);
    EXPECT_EQ((*moves)[0].index, (ControlPointIndex{6, 4}));
    EXPECT_LE(glm::length((*moves)[0].position - model.pointAt((*moves)[0]) + Vec3(0.01, 0.02, -0.01)), 1e-9);

    // Of the middle of the surface nothing else knows.
    pull.index = {3, 4};
    pull.position = model.pointAt(pull) + Vec3(1, 0, 0);
    EXPECT_EQ(keeper.follow({pull})->size(), 1u);
    EXPECT_TRUE(keeper.touchedEdges(*keeper.follow({pull})).empty());
}

TEST(KeepFriends, TakesAWholeCornerAlong)
{
    FriendModel model = knot();
    PointMove pull;
    pull.surface = 30;
    pull.index = {7, 7};
    const Vec3 far{0.03, -0.01, 0.02};
    pull.position = model.pointAt(pull) + far;
    const auto moves = model.keeper().follow({pull});
    ASSERT_TRUE(moves);
    EXPECT_EQ(moves->size(), 16u);
    for (const PointMove& move : *moves)
        EXPECT_LE(glm::length(move.position - model.pointAt(move) - far), 1e-9);
}

TEST(KeepFriends, RefusesWithTheReasonWhereTheOtherSideHasOtherKnots)
{
    FriendModel model = knot();
    model.surfaces[31] = withKnotInserted(model.surfaces[31], Direction::V, 2.5);
    const FriendKeeper keeper = model.keeper();
    PointMove pull;
    pull.surface = 30;
    pull.index = {7, 4};
    pull.position = model.pointAt(pull) + Vec3(0.01, 0, 0);
    const auto moves = keeper.follow({pull});
    ASSERT_FALSE(moves);
    EXPECT_NE(moves.error().sentence().find("surfaces 30 and 31"), std::string::npos);
    EXPECT_NE(moves.error().sentence().find("different degrees or knots"), std::string::npos);
    pull.index = {0, 4};  // the far edge
    EXPECT_TRUE(keeper.follow({pull}));
}

// Control points of such a surface do not lie on its edge.
TEST(KeepFriends, RefusesSurfacesThatAreNotClamped)
{
    std::mt19937 random(105);
    const NurbsSurface whole = testing::randomSurface(random, {.clamped = false});
    FriendModel model;
    model.surfaces = {whole, whole};
    model.join(0, Side::endU, 1, Side::startU);
    PointMove pull;
    pull.index = {whole.countU() - 1, 2};
    pull.position = model.pointAt(pull) + Vec3(0, 0, 0.1);
    const auto moves = model.keeper().follow({pull});
    ASSERT_FALSE(moves);
    EXPECT_NE(moves.error().sentence().find("do not end at it"), std::string::npos);
}

TEST(KeepFriends, RefusesToPullOnePointToTwoPlaces)
{
    FriendModel model = knot();
    PointMove first;
    first.surface = 30;
    first.index = {7, 4};
    first.position = model.pointAt(first) + Vec3(0.01, 0, 0);
    PointMove second = first;
    second.surface = 31;
    second.index = {0, 4};
    const FriendKeeper keeper = model.keeper();
    EXPECT_TRUE(keeper.follow({first, second}));
    second.position.y += 0.01;
    EXPECT_FALSE(keeper.follow({first, second}));
}

}  // namespace
}  // namespace knotspan
