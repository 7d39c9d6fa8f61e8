#include "ui/viewport/navigation.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace knotspan {
namespace {

constexpr PictureSize kSize{640, 400};

Camera tilted(bool orthographic)
{
    Camera camera;
    camera.eye = {30, -50, 20};
    camera.target = {1, 2, 3};
    camera.up = {0, 0, 1};
    camera.orthographic = orthographic;
    return camera;
}

TEST(Navigation, ZoomingKeepsWhatIsUnderTheCursor)
{
    for (const bool orthographic : {false, true}) {
        const Camera before = tilted(orthographic);
        const Vec3 point = before.target + before.right() * 7.0 + before.upward() * 4.0;
        const auto cursor = before.toPixel(point, kSize.width, kSize.height);
        ASSERT_TRUE(cursor.has_value());
        for (const double steps : {1.0, 5.0, -3.0}) {
            const auto after =
                zoomed(before, steps, *cursor, kSize).toPixel(point, kSize.width, kSize.height);
            ASSERT_TRUE(after.has_value());
            EXPECT_NEAR(after->x, cursor->x, 1e-6);
            EXPECT_NEAR(after->y, cursor->y, 1e-6);
        }
        EXPECT_LT(zoomed(before, 1, *cursor, kSize).distance(), before.distance());
    }
}

TEST(Navigation, PanningKeepsTheTargetUnderTheHand)
{
    for (const bool orthographic : {false, true}) {
        const Camera before = tilted(orthographic);
        const auto after = panned(before, {33, -12}, kSize).toPixel(before.target, kSize.width, kSize.height);
        ASSERT_TRUE(after.has_value());
        EXPECT_NEAR(after->x, 320 + 33, 1e-6);
        EXPECT_NEAR(after->y, 200 - 12, 1e-6);
    }
}

TEST(Navigation, OrbitingFollowsTheHand)
{
    const Camera before = tilted(false);
    // What faces the eye goes where the hand goes.
    const Vec3 facing = before.target - before.forward() * 5.0;
    const auto after = orbited(before, {20, 15}, kSize).toPixel(facing, kSize.width, kSize.height);
    ASSERT_TRUE(after.has_value());
    EXPECT_GT(after->x, 320);
    EXPECT_GT(after->y, 200);
}

TEST(Navigation, OrbitingNeverTurnsTheModelOver)
{
    Camera camera = tilted(false);
    for (int turn = 0; turn < 200; ++turn) {
        camera = orbited(camera, {3, 40}, kSize);
        EXPECT_GE(camera.upward().z, -1e-9);
        EXPECT_TRUE(std::isfinite(camera.eye.x));
    }
}

}  // namespace
}  // namespace knotspan
