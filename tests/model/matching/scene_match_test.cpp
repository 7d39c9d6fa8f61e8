#include "model/matching/scene_match.h"

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
            if (!match) {  // some cushions bend so sharply that their sides face each other
                EXPECT_NE(match.error().sentence().find("fold back"), std::string::npos)
                    << describe(start, edge) << ": " << match.error().sentence();
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
    EXPECT_GE(mended, 12);
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
