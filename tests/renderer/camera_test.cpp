#include "renderer/scene/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan::testing {
namespace {

std::vector<Vec3> corners()
{
    std::vector<Vec3> points;
    for (int corner = 0; corner < 8; ++corner)
        points.emplace_back((corner & 1) != 0 ? 4 : -1, (corner & 2) != 0 ? 2 : -2,
                            (corner & 4) != 0 ? 8 : 3);
    return points;
}

Box box()
{
    Box b;
    for (const Vec3& corner : corners())
        b.add(corner);
    return b;
}

TEST(Camera, HasANamedViewForEachNameOfTheList)
{
    for (const std::string& name : namedViews())
        EXPECT_TRUE(namedView(name, corners(), 1.5, false)) << name;
    EXPECT_FALSE(namedView("sideways", corners(), 1.5, false));
}

TEST(Camera, FitsTheWholeBoxIntoThePicture)
{
    for (const std::string& name : namedViews())
        for (const bool orthographic : {false, true}) {
            const Camera camera = namedView(name, corners(), 1.6, orthographic).value();
            double reach = 0;
            for (const Vec3& point : corners()) {
                const auto at = camera.toPixel(point, 1600, 1000);
                ASSERT_TRUE(at);
                EXPECT_TRUE(at->x >= 0 && at->x <= 1600 && at->y >= 0 && at->y <= 1000) << name;
                reach = std::max({reach, std::abs(at->x - 800) / 800, std::abs(at->y - 500) / 500});
            }
            EXPECT_GT(reach, 0.9) << name << " wastes the picture";
        }
}

// The matrix of the GPU and the formula of picking are two texts of one fact.
TEST(Camera, ProjectsByItsMatrixToWhereItPicks)
{
    for (const bool orthographic : {false, true}) {
        const Camera camera = namedView("iso", corners(), 1.6, orthographic).value();
        const Vec3 point(1.5, -0.5, 4.0);
        const Vec4 clip = camera.projection(1.6, box()) * (camera.rotation() * Vec4(point - camera.eye, 1.0));
        const Vec2 pixel((clip.x / clip.w * 0.5 + 0.5) * 1600, (clip.y / clip.w * 0.5 + 0.5) * 1000);
        const Vec2 expected = camera.toPixel(point, 1600, 1000).value();
        EXPECT_NEAR(pixel.x, expected.x, 1e-9);
        EXPECT_NEAR(pixel.y, expected.y, 1e-9);
        EXPECT_GT(clip.z / clip.w, 0.0);
        EXPECT_LT(clip.z / clip.w, 1.0);
    }
}

TEST(Camera, LooksAtAnEmptySceneFromSomewhere)
{
    const Camera camera = namedView("iso", {}, 1.5, false).value();
    EXPECT_TRUE(camera.toPixel(Vec3(0), 300, 200));
    EXPECT_GT(namedView("top", {Vec3(7)}, 1.5, true)->distance(), 0.0);
}

TEST(Camera, KeepsThePointUnderTheCursorWhileZooming)
{
    Camera camera = namedView("iso", corners(), 1.6, false).value();
    const Vec2 cursor(0.7, -0.4);
    const Vec3 held = camera.target + camera.right() * cursor.x + camera.upward() * cursor.y;
    const Vec2 before = camera.toPixel(held, 1600, 1000).value();
    camera.zoomAt(0.5, cursor);
    const Vec2 after = camera.toPixel(held, 1600, 1000).value();
    EXPECT_NEAR(glm::length(before - after), 0.0, 1e-9);
}

TEST(Camera, OrbitsAtItsDistanceAndNeverTurnsOver)
{
    Camera camera = namedView("top", corners(), 1.6, false).value();
    const double distance = camera.distance();
    for (int step = 0; step < 200; ++step) {
        camera.orbit(0.1, step % 3 == 0 ? 0.5 : -0.2);
        EXPECT_NEAR(camera.distance(), distance, 1e-9 * distance);
        EXPECT_GT(camera.upward().z, 0.0);
    }
}

TEST(Camera, SeesNothingBehindIt)
{
    const Camera camera = namedView("front", corners(), 1.6, false).value();
    EXPECT_FALSE(camera.toPixel(camera.eye - camera.forward(), 100, 100));
}

TEST(Camera, LooksStraightUpWithoutLosingItsMind)
{
    Camera camera;
    camera.eye = Vec3(0);
    camera.target = Vec3(0, 0, 5);
    camera.up = Vec3(0, 0, 1);
    EXPECT_NEAR(glm::length(camera.right()), 1.0, 1e-12);
    EXPECT_NEAR(glm::dot(camera.right(), camera.forward()), 0.0, 1e-12);
}

}  // namespace
}  // namespace knotspan::testing
