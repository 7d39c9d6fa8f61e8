#include "model/matching/drag_with_friends.h"

#include <limits>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/friends/scene_friends.h"
#include "model/geometry/knot_insertion.h"
#include "model/samples/net.h"
#include "model/samples/samples.h"

namespace knotspan {
namespace {

ObjectPull pulledBy(const Scene& scene, ObjectId id, ControlPointIndex index, const Vec3& way)
{
    return {id, index, controlPointInModel(*scene.find(id), index) + way};
}

void replace(Scene& scene, ObjectId id, NurbsSurface surface)
{
    auto changed = std::make_shared<SceneObject>(*scene.find(id));
    changed->surface = std::move(surface);
    scene.exchange(id, std::move(changed));
}

int changedObjects(const Scene& before, const Scene& after)
{
    int count = 0;
    for (const auto& [id, object] : before.objects())
        count += *object == *after.find(id) ? 0 : 1;
    return count;
}

constexpr ObjectId kSome{30};

TEST(DragWithFriends, IsWhatTheKeeperOfTheWholeSceneSays)
{
    const Scene start = makeKnot();
    SceneFriends friends;
    friends.follow(start);
    std::vector<PlacedSurface> surfaces;
    for (const auto& [id, object] : start.objects())
        surfaces.push_back({&object->surface, object->transform});
    const FriendKeeper keeper(surfaces, friends.edges());
    for (const ControlPointIndex index : {ControlPointIndex{3, 3}, {1, 4}, {0, 4}, {7, 7}, {6, 6}, {1, 7}}) {
        const ObjectPull pull = pulledBy(start, kSome, index, {0.02, -0.01, 0.03});
        Scene scene = start;
        DragWithFriends drag(start);
        auto edit = drag.pull({pull});
        ASSERT_TRUE(edit) << edit.error().sentence();
        edit->applyTo(scene);
        const auto moves = keeper.follow({{30, index, pull.position}});
        ASSERT_TRUE(moves);
        for (std::uint32_t k = 0; k < surfaces.size(); ++k)
            EXPECT_EQ(scene.find(ObjectId{k})->surface, withMoves(*surfaces[k].surface, k, *moves)) << k;
        friends.follow(scene);
        for (const FriendEdge& edge : friends.edges())
            EXPECT_TRUE(edge.areFriends());
    }
}

TEST(DragWithFriends, PutsBackWhatOnlyAnEarlierPlaceMoved)
{
    const Scene start = makeKnot();
    Scene scene = start;
    DragWithFriends drag(start);
    auto there = drag.pull({pulledBy(start, kSome, {7, 7}, {0.02, 0, 0})});
    ASSERT_TRUE(there);
    there->applyTo(scene);
    EXPECT_EQ(changedObjects(start, scene), 4);  // all that meet at the corner
    auto back = drag.pull({pulledBy(start, kSome, {7, 7}, {0, 0, 0})});
    ASSERT_TRUE(back);
    back->applyTo(scene);
    EXPECT_TRUE(scene == start);
    back->applyTo(scene);  // as undo does
    there->applyTo(scene);
    EXPECT_TRUE(scene == start);
}

TEST(DragWithFriends, RefusesInTheNamesOfTheObjects)
{
    Scene start = makeKnot();
    replace(start, ObjectId{31}, withKnotInserted(start.find(ObjectId{31})->surface, Direction::V, 2.5));
    DragWithFriends drag(start);
    const auto edit = drag.pull({pulledBy(start, kSome, {7, 4}, {0.02, 0, 0})});
    ASSERT_FALSE(edit);
    const std::string sentence = edit.error().sentence();
    EXPECT_NE(sentence.find('"' + start.find(kSome)->name + '"'), std::string::npos) << sentence;
    EXPECT_NE(sentence.find('"' + start.find(ObjectId{31})->name + '"'), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("switch off Keep friends"), std::string::npos) << sentence;
}

TEST(DragWithFriends, LeavesHiddenObjectsWhereTheyAre)
{
    Scene start = makeKnot();
    auto hidden = std::make_shared<SceneObject>(*start.find(ObjectId{31}));
    hidden->visible = false;
    start.exchange(ObjectId{31}, hidden);
    Scene scene = start;
    DragWithFriends drag(start);
    auto edit = drag.pull({pulledBy(start, kSome, {7, 4}, {0.02, 0, 0})});
    ASSERT_TRUE(edit);
    edit->applyTo(scene);
    EXPECT_EQ(changedObjects(start, scene), 1);
    EXPECT_EQ(*scene.find(ObjectId{31}), *hidden);
}

// Objects that stand in the model by a transform each are pulled in the model's space.
TEST(DragWithFriends, PullsInTheSpaceOfTheModel)
{
    Scene start = makeHull();
    const Mat4 place = glm::rotate(glm::translate(Mat4(1.0), Vec3(5, 1, -2)), 0.6, Vec3(1, 2, 0));
    const Scene::Objects objects = start.objects();
    for (const auto& [id, object] : objects) {
        auto placed = std::make_shared<SceneObject>(*object);
        placed->transform = place;
        start.exchange(id, std::move(placed));
    }
    SceneFriends friends;
    friends.follow(start);
    const std::vector<FriendEdge> before = friends.edges();
    const ObjectId id = start.objects().begin()->first;
    const ObjectPull pull = pulledBy(start, id, {1, 1}, {0.03, 0.02, 0.05});
    DragWithFriends drag(start);
    auto edit = drag.pull({pull});
    ASSERT_TRUE(edit) << edit.error().sentence();
    edit->applyTo(start);
    EXPECT_LE(glm::length(controlPointInModel(*start.find(id), {1, 1}) - pull.position), 1e-12);
    friends.follow(start);
    ASSERT_EQ(friends.edges().size(), before.size());
    for (size_t k = 0; k < before.size(); ++k)
        EXPECT_EQ(friends.edges()[k].areFriends(), before[k].areFriends()) << k;
}

// Control points of two sheets that are 0.002 apart along their edge are within one gap tolerance, not within
// another.
TEST(DragWithFriends, TakesTheGapThatItWasToldForRowsThatGoWithEachOther)
{
    const KnotVector knots = KnotVector::clampedUniform(2, 1);
    Scene scene;
    for (const double way : {-1.0, 1.0})
        scene.exchange(ObjectId{way < 0 ? 1U : 2U},
                       std::make_shared<SceneObject>(namedObject(
                           "Sheet", {}, surfaceOf(knots, knots, [&](int i, int j) -> ControlPoint {
                               return {{way * i, 5 * j + (way > 0 && j == 1 ? 0.002 : 0), 0}, 1};
                           }))));
    const ObjectPull pull = pulledBy(scene, ObjectId{1}, {0, 1}, {0, 0, 2});
    EXPECT_TRUE(DragWithFriends(scene, {0.01, 0.1, 0.01}).pull({pull}));
    EXPECT_FALSE(DragWithFriends(scene, {0.001, 0.1, 0.01}).pull({pull}));
}

TEST(DragWithFriends, RefusesPlacesThatAreNoNumbers)
{
    const Scene start = makeNine16();
    DragWithFriends drag(start);
    const double infinity = std::numeric_limits<double>::infinity();
    const auto edit = drag.pull({{start.objects().begin()->first, {1, 1}, Vec3(infinity, 0, 0)}});
    ASSERT_FALSE(edit);
    EXPECT_NE(edit.error().sentence().find("infinitely far"), std::string::npos);
}

}  // namespace
}  // namespace knotspan
