#include "model/scene/scene.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "tests/model/scene/simple_object.h"

namespace knotspan {
namespace {

using testing::simpleObject;

TEST(Scene, NumbersItsObjectsFromZeroAndNeverAgain)
{
    Scene scene;
    EXPECT_EQ(scene.add(simpleObject("a")), ObjectId{0});
    EXPECT_EQ(scene.add(simpleObject("b")), ObjectId{1});
    scene.exchange(ObjectId{1}, nullptr);
    EXPECT_EQ(scene.add(simpleObject("c")), ObjectId{2});
    EXPECT_EQ(scene.find(ObjectId{1}), nullptr);
    EXPECT_EQ(scene.find(ObjectId{2})->name, "c");
}

TEST(Scene, ExchangeReturnsWhatStoodThere)
{
    Scene scene;
    const ObjectId id = scene.add(simpleObject("a"));
    const SharedObject first = scene.find(id);
    const SharedObject second = testing::sharedObject("b");
    EXPECT_EQ(scene.exchange(id, second), first);
    EXPECT_EQ(scene.find(id), second);
    EXPECT_EQ(scene.exchange(id, nullptr), second);
    EXPECT_EQ(scene.exchange(id, first), nullptr);
}

TEST(Scene, IsAValueWhoseCopyIsASnapshot)
{
    Scene scene;
    const ObjectId id = scene.add(simpleObject("a"));
    const Scene snapshot = scene;
    scene.exchange(id, nullptr);
    EXPECT_EQ(snapshot.find(id)->name, "a");
    EXPECT_FALSE(snapshot == scene);
}

TEST(Scene, EqualsAnotherWithEqualObjectsUnderTheSameIds)
{
    Scene a;
    Scene b;
    a.add(simpleObject("a"));
    b.add(simpleObject("a"));
    EXPECT_TRUE(a == b);
    b.setUnits("in");
    EXPECT_FALSE(a == b);
    b.setUnits("mm");
    b.exchange(ObjectId{0}, testing::sharedObject("other"));
    EXPECT_FALSE(a == b);
}

TEST(Scene, CountsAndBoundsWhatItHolds)
{
    Scene scene;
    EXPECT_TRUE(scene.bounds().isEmpty());
    scene.add(simpleObject("a"));
    SceneObject moved = simpleObject("b");
    moved.transform = glm::translate(Mat4(1.0), Vec3(10, 0, 1));
    scene.add(moved);
    moved.visible = false;
    moved.transform = glm::translate(Mat4(1.0), Vec3(500, 0, 0));
    scene.add(moved);
    EXPECT_EQ(scene.bounds().low, Vec3(0, 0, 0));
    EXPECT_EQ(scene.bounds().high, Vec3(12, 3, 1)) << "hidden objects count for nothing";
    EXPECT_EQ(scene.ksQuadCount(), 3u);
    EXPECT_EQ(scene.controlPointCount(), 12u);
}

}  // namespace
}  // namespace knotspan
