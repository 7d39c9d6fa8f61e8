// What a scene knows of how it came from another one.
#include <algorithm>

#include <gtest/gtest.h>

#include "model/scene/edit.h"
#include "model/scene/object_counts.h"
#include "tests/model/scene/simple_object.h"

namespace knotspan {
namespace {

using testing::sharedObject;
using testing::simpleObject;

using Ids = std::vector<ObjectId>;

Scene sceneOf(int objects)
{
    Scene scene;
    for (int k = 0; k < objects; ++k)
        scene.add(simpleObject("object " + std::to_string(k)));
    return scene;
}

// Each once.
std::optional<Ids> changed(const Scene& earlier, const Scene& later)
{
    auto ids = later.changedSince(earlier);
    if (ids) {
        std::sort(ids->begin(), ids->end());
        ids->erase(std::unique(ids->begin(), ids->end()), ids->end());
    }
    return ids;
}

TEST(SceneChanges, OfACopyAreNone)
{
    const Scene scene = sceneOf(100);
    const Scene copy = scene;
    EXPECT_EQ(changed(copy, scene), Ids{});
    EXPECT_EQ(changed(scene, copy), Ids{});
}

TEST(SceneChanges, AreTheObjectsExchangedSince)
{
    Scene scene = sceneOf(100);
    const Scene before = scene;
    scene.exchange(ObjectId{7}, sharedObject("other"));
    scene.exchange(ObjectId{3}, nullptr);
    const Scene between = scene;
    scene.exchange(ObjectId{7}, sharedObject("another"));
    EXPECT_EQ(changed(before, scene), (Ids{ObjectId{3}, ObjectId{7}}));
    EXPECT_EQ(changed(between, scene), Ids{ObjectId{7}});
    EXPECT_EQ(changed(scene, before), std::nullopt);
}

TEST(SceneChanges, AreUnknownBetweenScenesThatWentDifferentWays)
{
    const Scene before = sceneOf(3);
    Scene one = before;
    Scene other = before;
    one.exchange(ObjectId{1}, sharedObject("a"));
    other.exchange(ObjectId{1}, sharedObject("b"));
    EXPECT_EQ(changed(one, other), std::nullopt);
    EXPECT_EQ(changed(sceneOf(3), before), std::nullopt);
}

TEST(SceneChanges, AreUnknownAfterManyOfThem)
{
    Scene scene = sceneOf(3);
    const Scene before = scene;
    for (int k = 0; k < 1000; ++k)
        scene.exchange(ObjectId{1}, sharedObject("a"));
    EXPECT_EQ(changed(before, scene), std::nullopt);
}

TEST(SceneChanges, OfAMovedFromSceneAreThoseOfAnEmptyOne)
{
    Scene scene = sceneOf(2);
    const Scene before = scene;
    Scene moved = std::move(scene);
    EXPECT_EQ(changed(before, moved), Ids{});
    scene = sceneOf(1);
    EXPECT_EQ(changed(before, scene), std::nullopt);
    EXPECT_EQ(scene.objects().size(), 1U);
}

TEST(SceneChanges, AreAllThatACopyTakesOver)
{
    Scene scene = sceneOf(100);
    Scene held = scene;
    const Scene unrelated = sceneOf(5);
    const auto expectSame = [&] {
        held = scene;
        EXPECT_EQ(held.objects(), scene.objects());  // the same pointers
    };
    for (int step = 0; step < 300; ++step) {
        for (int k = 0; k < step % 50; ++k)
            scene.exchange(ObjectId{static_cast<std::uint32_t>(k * 7 % 100)},
                           k % 5 == 0 ? nullptr : sharedObject(std::to_string(step)));
        if (step % 37 == 0)
            held = unrelated;
        expectSame();
    }
}

TEST(ObjectCounts, AreThoseOfTheSceneHoweverItChanges)
{
    Scene scene = sceneOf(40);
    ObjectCounts counts;
    for (int step = 0; step < 200; ++step) {
        for (int k = 0; k < step % 45; ++k) {
            SceneObject object = simpleObject("a");
            object.visible = (step + k) % 3 != 0;
            object.locked = (step * k) % 5 == 0;
            scene.exchange(ObjectId{static_cast<std::uint32_t>(k * 11 % 40)},
                           (step + k) % 7 == 0 ? nullptr : std::make_shared<const SceneObject>(object));
        }
        counts.follow(scene);
        size_t hidden = 0;
        size_t locked = 0;
        for (const auto& [id, object] : scene.objects()) {
            hidden += object->visible ? 0 : 1;
            locked += object->locked ? 1 : 0;
        }
        ASSERT_EQ(counts.hidden(), hidden);
        ASSERT_EQ(counts.locked(), locked);
    }
}

TEST(SceneChanges, OfAnEditThatIsAppliedAndTakenBackAreItsObjects)
{
    Scene scene = sceneOf(100);
    const Scene before = scene;
    Edit edit;
    edit.set(ObjectId{5}, sharedObject("edited"));
    edit.applyTo(scene);
    edit.applyTo(scene);
    EXPECT_EQ(changed(before, scene), Ids{ObjectId{5}});
    EXPECT_EQ(scene, before);
}

}  // namespace
}  // namespace knotspan
