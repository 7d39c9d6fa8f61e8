// Match and Keep friends beside trim curves, which neither can move: they refuse, and say why.
#include <gtest/gtest.h>

#include "model/matching/drag_with_friends.h"
#include "model/matching/scene_match.h"
#include "model/samples/net.h"

namespace knotspan {
namespace {

TrimCurve line(const Vec2& from, const Vec2& to)
{
    return TrimCurve::create(KnotVector::clampedUniform(1, 1), {{from, 1}, {to, 1}}).value();
}

// A flat bicubic sheet over [0, 6] x [0, 6], of which the part between two values of u is left.
SceneObject sheet(const char* name, double from, double to)
{
    const KnotVector knots = clampedIntegerKnots(3, 6);
    SceneObject object =
        namedObject(name, {}, surfaceOf(knots, knots, [&](int i, int j) {
                        return ControlPoint{{grevilleAbscissa(knots, i), grevilleAbscissa(knots, j), 0}, 1};
                    }));
    object.trimLoops = {{true,
                         {line({from, 0}, {to, 0}), line({to, 0}, {to, 6}), line({to, 6}, {from, 6}),
                          line({from, 6}, {from, 0})}}};
    return object;
}

class TrimmedEdges : public ::testing::Test {
protected:
    TrimmedEdges() : left(scene.add(sheet("Left", 0, 2.5))), right(scene.add(sheet("Right", 2.5, 6))) {}

    Scene scene;
    ObjectId left;
    ObjectId right;
};

TEST_F(TrimmedEdges, AreFoundAndNotMatched)
{
    const auto edges = edgesOf(scene, {left}, {});
    ASSERT_EQ(edges.size(), 1U);
    EXPECT_EQ(edges[0].edge.a.trim, (TrimPlace{0, 1}));
    EXPECT_TRUE(foundAgain(scene, edges[0], {}));
    EXPECT_EQ(describe(scene, edges[0]), "loop 1 curve 2 of \"Left\" and loop 1 curve 4 of \"Right\"");
    const auto match = matchInScene(scene, edges[0], Continuity::g1, MatchSides::a, {});
    ASSERT_FALSE(match);
    EXPECT_NE(match.error().sentence().find("trim curve"), std::string::npos) << match.error().sentence();
}

TEST_F(TrimmedEdges, HoldThePointsThatShapeThem)
{
    DragWithFriends drag(scene, {});
    const auto pull = [&](int i) { return drag.pull({{left, {i, 4}, Vec3(i, 4, 1)}}); };
    const auto refused = pull(4);  // its basis function reaches over the curve at u = 2.5
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("cut out by a trim curve"), std::string::npos)
        << refused.error().sentence();
    EXPECT_TRUE(pull(0));
    EXPECT_TRUE(pull(8));  // on the part that is cut away
}

}  // namespace
}  // namespace knotspan
