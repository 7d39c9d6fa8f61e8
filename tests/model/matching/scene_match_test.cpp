#include "model/matching/scene_match.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "model/samples/samples.h"

namespace knotspan {
namespace {

std::vector<ObjectEdge> everyEdge(const Scene& scene)
{
    std::set<ObjectId> all;
    for (const auto& [id, object] : scene.objects())
        all.insert(id);
    return edgesOf(scene, all, {});
}

// The creased patchwork: 12 inner edges.
TEST(SceneMatch, MakesACreaseSmoothByAnEditThatTakesItselfBack)
{
    const Scene start = makeNine16();
    const std::vector<ObjectEdge> edges = everyEdge(start);
    ASSERT_EQ(edges.size(), 12u);
    int mended = 0;
    for (const ObjectEdge& edge : edges) {
        EXPECT_EQ(edge.edge.continuity, Continuity::g0);
        for (const MatchSides move : {MatchSides::a, MatchSides::b, MatchSides::both}) {
            auto match = matchInScene(start, edge, Continuity::g1, move, {1e-3, 0.01, 0.01});
            // Some cushions bend so sharply that their sides face each other.
            ASSERT_EQ(match.has_value(), edge.edge.angleMaxDeg < 90)
                << describe(start, edge) << (match ? "" : ": " + match.error().sentence());
            if (!match) {
                EXPECT_NE(match.error().sentence().find("less than 90"), std::string::npos)
                    << match.error().sentence();
                continue;
            }
            ++mended;
            Scene scene = start;
            match->edit.applyTo(scene);
            EXPECT_EQ(*scene.find(edge.a) == *start.find(edge.a), move == MatchSides::b);
            EXPECT_EQ(*scene.find(edge.b) == *start.find(edge.b), move == MatchSides::a);
            const auto after = foundAgain(scene, edge, {});
            ASSERT_TRUE(after.has_value());
            EXPECT_TRUE(after->edge.areFriends()) << describe(start, edge);
            EXPECT_LE(after->edge.angleBoundDeg, 0.011);
            match->edit.applyTo(scene);
            EXPECT_TRUE(scene == start);
        }
    }
    EXPECT_EQ(mended, 12);
}

TEST(SceneMatch, KeepsTrimLoopsAndTheParametersThatTheyAreIn)
{
    Scene scene = makeNine16();
    const ObjectEdge edge = everyEdge(scene).front();
    auto trimmed = std::make_shared<SceneObject>(*scene.find(edge.b));
    const KnotVector line = KnotVector::create(1, {0, 0, 1, 1}).value();
    const auto curve = [&](Vec2 from, Vec2 to) {
        return TrimCurve::create(line, {{from, 1}, {to, 1}}).value();
    };
    const double end = trimmed->surface.knotsU().domainEnd();
    TrimLoop loop;
    loop.curves = {curve({0, 0}, {end, 0}), curve({end, 0}, {0, end}), curve({0, end}, {0, 0})};
    trimmed->trimLoops = {loop};
    scene.exchange(edge.b, trimmed);
    auto match = matchInScene(scene, edge, Continuity::g1, MatchSides::b, {1e-3, 0.01, 0.01});
    ASSERT_TRUE(match) << match.error().sentence();
    match->edit.applyTo(scene);
    const SceneObject& after = *scene.find(edge.b);
    EXPECT_FALSE(after.surface == trimmed->surface);
    EXPECT_EQ(after.trimLoops, trimmed->trimLoops);
    for (const auto knots : {&NurbsSurface::knotsU, &NurbsSurface::knotsV}) {
        EXPECT_EQ((after.surface.*knots)().domainStart(), (trimmed->surface.*knots)().domainStart());
        EXPECT_EQ((after.surface.*knots)().domainEnd(), (trimmed->surface.*knots)().domainEnd());
    }
}

TEST(SceneMatch, LooksAtEdgesOfTheseObjectsOnly)
{
    const Scene scene = makeNine16();
    const ObjectId corner = scene.objects().begin()->first;
    EXPECT_EQ(edgesOf(scene, {corner}, {}).size(), 2u);
    EXPECT_TRUE(edgesOf(scene, {ObjectId{99}}, {}).empty());
}

// On the centre line the two halves mirror each other; whatever turns one there parts it from its neighbour.
TEST(SceneMatch, TellsWhichOtherEdgesItSpoils)
{
    const Scene start = makeHull();
    int spoilt = 0;
    for (const ObjectEdge& edge : everyEdge(start)) {
        if (edge.edge.continuity != Continuity::g0)
            continue;
        const FriendTolerances tolerances;
        const auto match = matchInScene(start, edge, Continuity::g1, MatchSides::b, tolerances);
        if (!match)
            continue;
        const SideEffects effects = sideEffects(start, edge, *match, tolerances);
        Scene then = start;
        Edit edit = match->edit;
        edit.applyTo(then);
        SceneFriends before(tolerances);
        SceneFriends after(tolerances);
        before.follow(start);
        after.follow(then);
        const auto count = [](const SceneFriends& friends, Continuity continuity) {
            return std::count_if(friends.edges().begin(), friends.edges().end(),
                                 [&](const FriendEdge& one) { return one.continuity == continuity; });
        };
        const bool lost = count(after, Continuity::g2) < count(before, Continuity::g2);
        EXPECT_EQ(!effects.worse.empty(), lost) << describe(start, edge);
        if (after.nakedEdges().size() > before.nakedEdges().size()) {
            EXPECT_FALSE(effects.isEmpty()) << describe(start, edge);
        }
        for (const SideEffects::Worse& worse : effects.worse) {
            EXPECT_FALSE(isSameEdge(worse.edge, edge));
            EXPECT_TRUE(worse.edge.a == edge.b || worse.edge.b == edge.b);
            const auto now = foundAgain(then, worse.edge, tolerances);
            EXPECT_EQ(now.has_value(), worse.after.has_value());
            if (now && worse.after) {
                EXPECT_LT(smoothnessRank(*worse.after), smoothnessRank(worse.edge.edge.continuity));
            }
            ++spoilt;
        }
    }
    EXPECT_GT(spoilt, 0);
}

TEST(SceneMatch, RefusesWhereAnObjectIsGone)
{
    Scene scene = makeNine16();
    const ObjectEdge edge = everyEdge(scene).front();
    scene.exchange(edge.b, nullptr);
    const auto match = matchInScene(scene, edge, Continuity::g1, MatchSides::b, {});
    ASSERT_FALSE(match);
    EXPECT_NE(match.error().sentence().find("no longer there"), std::string::npos);
    EXPECT_FALSE(foundAgain(scene, edge, {}).has_value());
}

}  // namespace
}  // namespace knotspan
