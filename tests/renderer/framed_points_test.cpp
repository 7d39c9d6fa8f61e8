// What views frame of trimmed surfaces.
#include "renderer/scene/framed_points.h"

#include <gtest/gtest.h>

#include "model/geometry/primitives.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

Box boxOf(const Scene& scene)
{
    Box box;
    for (const Vec3& point : framedPoints(scene))
        box.add(point);
    return box;
}

TEST(FramedPoints, OfASmallPartAreNotThoseOfTheWholeSurface)
{
    SceneObject object{.surface = plane({-100, -100, 0}, {200, 0, 0}, {0, 200, 0})};
    object.transform[3] = Vec4(7, 0, 0, 1);
    Scene scene;
    const ObjectId id = scene.add(object);
    EXPECT_EQ(boxOf(scene).low, Vec3(-93, -100, 0));
    object.trimLoops = {{true, {circle({0.5, 0.5}, 0.01)}}, {false, {circle({0.5, 0.5}, 0.002, false)}}};
    scene.exchange(id, std::make_shared<SceneObject>(object));
    const Box box = boxOf(scene);
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(box.high[axis] - box.low[axis], 4, 1e-9);
        EXPECT_NEAR(box.centre()[axis], axis == 0 ? 7 : 0, 1e-9);
    }
    // All around a hole alone is left, and all where the loops are none.
    object.trimLoops = {{false, {circle({0.5, 0.5}, 0.01, false)}}};
    scene.exchange(id, std::make_shared<SceneObject>(object));
    EXPECT_EQ(boxOf(scene).low, Vec3(-93, -100, 0));
    object.trimLoops = {{true, {polyline({{0.5, 0.5}, {0.6, 0.5}, {0.6, 0.6}})}}};
    scene.exchange(id, std::make_shared<SceneObject>(object));
    EXPECT_EQ(boxOf(scene).low, Vec3(-93, -100, 0));
}

TEST(FramedPoints, AreThoseOfTheHullWhereNothingIsTrimmedOrShown)
{
    Scene scene;
    SceneObject object{.surface = sphere({1, 2, 3}, 4)};
    scene.add(object);
    EXPECT_EQ(framedPoints(scene), scene.hullPoints());
    object.visible = false;
    object.trimLoops = {{true, {circle({1, 1}, 0.5)}}};
    scene.add(object);
    EXPECT_EQ(framedPoints(scene), scene.hullPoints());
}

}  // namespace
}  // namespace knotspan::testing
