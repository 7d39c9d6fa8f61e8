// How far apart models are whose meshes are not as near to them as was asked.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/geometry/primitives.h"
#include "model/mesh/scene_distance.h"
#include "model/mesh/tessellation.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan {
namespace {

using testing::circle;
using testing::polyline;

Scene lifted(const Scene& scene, double height)
{
    Scene result;
    for (const auto& [id, object] : scene.objects()) {
        SceneObject copy = *object;
        copy.transform = glm::translate(Mat4(1.0), Vec3(0, 0, height)) * copy.transform;
        result.add(std::move(copy));
    }
    return result;
}

void expectDistance(const Scene& a, const Scene& b, double distance, double accuracy)
{
    const auto found = distanceBetween(a, b);
    ASSERT_TRUE(found) << found.error().sentence();
    EXPECT_LE(found->uncertainty(), accuracy);
    EXPECT_NEAR(found->larger().largest, distance, found->uncertainty());
}

// A hole that reaches over the edge by next to nothing: coarse chords do not, fine ones do, and then nobody
// knows how far the mesh is off.
TEST(ComparedModels, AreTheNearestMeshesNotTheFinest)
{
    constexpr double kOver = 1e-4;
    // Where a third of an arc's parameters are, which halving never meets.
    const double w = std::sqrt(0.5);
    const double angle = 1.5 * M_PI + std::atan2(4 * w + 1, 4 + 4 * w);
    const Vec2 out(std::cos(angle), std::sin(angle));
    const Vec2 along(-out.y, out.x);
    const Vec2 edge = (2 - kOver) * out;
    Scene scene;
    scene.add({.name = "plate",
               .surface = testing::flatSurface({-6, 6}, {-6, 6}),
               .trimLoops = {{true,
                              {polyline({edge - 3.0 * along, edge + 3.0 * along, 3.0 * (along - out),
                                         -3.0 * (along + out), edge - 3.0 * along})}},
                             {false, {circle({0, 0}, 2, false)}}}});
    const auto fine = tessellate(scene, {.deviation = 1e-5});
    ASSERT_TRUE(fine);
    ASSERT_EQ(fine->crossing, 1U);
    ASSERT_GT(fine->bound, 1);
    expectDistance(scene, lifted(scene, 3e-3), 3e-3, 0.01);
}

// Edges that are apart are joined in a mesh for a file, which moves its vertices; not in one to compare.
TEST(ComparedModels, AreAsNearWhereEdgesAreApart)
{
    constexpr double kGap = 2e-4;
    const TrimLoop square{true, {polyline({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}})}};
    Scene scene;
    scene.add({.name = "left", .surface = plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), .trimLoops = {square}});
    scene.add(
        {.name = "right", .surface = plane({1 + kGap, 0, 0}, {1, 0, 0}, {0, 1, 0}), .trimLoops = {square}});
    const auto joined = tessellate(scene, {.deviation = 1e-5});
    ASSERT_TRUE(joined);
    EXPECT_GT(joined->bound, 0.49 * kGap);
    const auto apart = tessellate(scene, {.deviation = 1e-5, .joinsEdges = false});
    ASSERT_TRUE(apart);
    EXPECT_LE(apart->bound, 1e-12);
    expectDistance(scene, lifted(scene, 1e-3), 1e-3, 1e-6);
}

}  // namespace
}  // namespace knotspan
