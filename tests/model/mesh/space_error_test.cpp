#include "model/mesh/space_error.h"

#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/mesh/deviation_measuring.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

// The largest distance of the surface's points, by the reference evaluation, from the triangle with the same
// parameters, sampled far more densely than measuredDeviation() does.
double bruteForce(const Tessellation& mesh, const Scene& scene, int steps)
{
    double largest = 0;
    for (size_t p = 0; p < mesh.patches.size(); ++p) {
        const MeshPatch& patch = mesh.patches[p];
        const SharedObject object = scene.find(patch.object);
        const KnotVector& u = object->surface.knotsU();
        const KnotVector& v = object->surface.knotsV();
        for (size_t k = patch.firstTriangle; k < mesh.endOf(p); ++k) {
            const TriangleParameters& t = mesh.parameters[k];
            std::array<Vec3, 3> corners;
            for (size_t c = 0; c < 3; ++c)
                corners[c] = mesh.mesh.vertices[mesh.mesh.triangles[k][c]];
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j) {
                    const double x = double(i) / steps;
                    const double y = double(j) / steps;
                    const Vec2 at = (1 - x - y) * t[0] + x * t[1] + y * t[2];
                    // Just inside, so that a crease counts from this side.
                    const auto within = [](const KnotVector& knots, int span, double s) {
                        return knots[span] + (knots[span + 1] - knots[span]) * std::min(s, 1 - 1e-12);
                    };
                    const Vec3 point = evaluate(object->surface, within(u, patch.quad.spanU, at.x),
                                                within(v, patch.quad.spanV, at.y))
                                           .position;
                    largest =
                        std::max(largest, distanceToTriangle(transformed(point, object->transform), corners));
                }
        }
    }
    return largest;
}

TEST(SpaceError, BoundsEveryRandomSurfaceOfAnyDegree)
{
    std::mt19937 random(7);
    for (int round = 0; round < 27; ++round) {
        testing::RandomSurfaceShape shape;
        shape.degreeU = 1 + round % 9;
        shape.degreeV = 1 + (4 * round + 2) % 9;
        shape.spans = 1 + round % 2;
        shape.rational = round % 2 == 0;
        shape.clamped = round % 5 != 0;
        Scene scene;
        Mat4 transform(1.0);
        if (round % 3 == 0)
            transform = glm::scale(glm::rotate(Mat4(1.0), 0.7, Vec3(1, 2, 3)), Vec3(1, 3, 0.5));
        scene.add(
            {.name = "random", .transform = transform, .surface = testing::randomSurface(random, shape)});
        const double size = scene.bounds().diagonal();
        for (const double share : {0.1, 0.03}) {
            const auto mesh = tessellate(scene, {.deviation = share * size});
            ASSERT_TRUE(mesh) << mesh.error().sentence();
            EXPECT_LE(mesh->bound, share * size);
            EXPECT_LE(bruteForce(*mesh, scene, 4), mesh->bound * (1 + 1e-9)) << "round " << round;
        }
    }
}

TEST(SpaceError, IsNotFarAboveTheTruth)
{
    std::mt19937 random(11);
    std::vector<double> ratios;
    for (int round = 0; round < 20; ++round) {
        const Scene scene = testing::sceneOf(
            testing::randomSurface(random, {.degreeU = 3, .degreeV = 3, .rational = round % 2 == 0}));
        const auto mesh = tessellate(scene, {.deviation = 0.003 * scene.bounds().diagonal()});
        ASSERT_TRUE(mesh);
        ratios.push_back(mesh->bound / measuredDeviation(*mesh, scene).largest);
    }
    std::sort(ratios.begin(), ratios.end());
    EXPECT_LT(ratios[ratios.size() / 2], 2);
}

TEST(SpaceError, TakesTwoTrianglesForWhatIsFlat)
{
    const BezierNet flat{1, 1, {{0, 0, 0, 1}, {0, 1, 0, 1}, {2, 0, 0, 1}, {2, 1, 0, 1}}};
    SpaceError error(flat);
    const auto chosen = chooseSpaceGrid(error, 1e-12);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->grid, (Grid{1, 1}));
    EXPECT_EQ(chosen->bound, 0);
}

TEST(SpaceError, TakesMoreCellsOnlyAlongWhatIsBent)
{
    // A quarter of a cylinder: straight along v.
    const double w = std::sqrt(0.5);
    const BezierNet bent{
        2, 1, {{1, 0, 0, 1}, {1, 0, 9, 1}, {w, w, 0, w}, {w, w, 9 * w, w}, {0, 1, 0, 1}, {0, 1, 9, 1}}};
    SpaceError error(bent);
    const auto chosen = chooseSpaceGrid(error, 1e-4);
    ASSERT_TRUE(chosen);
    EXPECT_EQ(chosen->grid.v, 1);
    // An arc of 90 degrees in n chords is 1 - cos(45 degrees / n) away.
    const double fewest = std::ceil(M_PI / 4 / std::acos(1 - 1e-4));
    EXPECT_GE(chosen->grid.u, fewest);
    EXPECT_LE(chosen->grid.u, 1.5 * fewest);
}

TEST(SpaceError, HoldsForTinyHugeAndDistantModels)
{
    std::mt19937 random(3);
    for (const double scale : {1e-9, 1.0, 1e9})
        for (const double offset : {0.0, 1e6}) {
            Scene scene;
            Mat4 transform = glm::scale(Mat4(1.0), Vec3(scale));
            transform[3] = Vec4(Vec3(offset * scale), 1);
            scene.add({.name = "far",
                       .transform = transform,
                       .surface = testing::randomSurface(random, {.rational = true})});
            const double size = scene.bounds().diagonal();
            const auto mesh = tessellate(scene, {.deviation = 0.01 * size});
            ASSERT_TRUE(mesh) << mesh.error().sentence();
            for (const Vec3& vertex : mesh->mesh.vertices)
                ASSERT_TRUE(std::isfinite(vertex.x + vertex.y + vertex.z));
            EXPECT_LE(measuredDeviation(*mesh, scene).largest, 0.01 * size);
        }
}

}  // namespace
}  // namespace knotspan
