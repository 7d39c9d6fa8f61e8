#include "model/mesh/mesh_distance.h"

#include <random>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/analysis/surface_bounds.h"
#include "model/mesh/deviation_measuring.h"
#include "model/mesh/nearest_triangle.h"
#include "model/mesh/scene_distance.h"
#include "model/mesh/tessellation.h"
#include "model/samples/sample_list.h"
#include "tests/model/mesh/vtk_mesh.h"

namespace knotspan {
namespace {

Scene scaled(const std::string& sample, double factor)
{
    const Scene from = findSample(sample)->make();
    Scene scene;
    for (const auto& [id, object] : from.objects()) {
        SceneObject copy = *object;
        copy.transform = glm::scale(Mat4(1.0), Vec3(factor)) * copy.transform;
        scene.add(std::move(copy));
    }
    return scene;
}

TriangleMesh meshOf(const Scene& scene, double deviation)
{
    return tessellate(scene, {deviation, {}, false, 20'000'000}).value().mesh;
}

// A hilly sheet of n x n cells, whose hills stand elsewhere for another seed.
TriangleMesh hills(std::uint32_t n, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(0, 0.4);
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i <= n; ++i)
        for (std::uint32_t j = 0; j <= n; ++j)
            mesh.vertices.emplace_back(i / double(n), j / double(n), height(random));
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t a = i * (n + 1) + j;
            mesh.triangles.push_back({a, a + n + 1, a + 1});
            mesh.triangles.push_back({a + 1, a + n + 1, a + n + 2});
        }
    return mesh;
}

double bruteDistance(const Vec3& point, const TriangleMesh& mesh)
{
    double nearest = 1e300;
    for (const auto& [a, b, c] : mesh.triangles)
        nearest = std::min(nearest,
                           distanceToTriangle(point, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}));
    return nearest;
}

// The largest over a fine net of points on every triangle.
double bruteLargest(const TriangleMesh& from, const TriangleMesh& to, int parts)
{
    double largest = 0;
    for (const auto& [a, b, c] : from.triangles)
        for (int i = 0; i <= parts; ++i)
            for (int j = 0; i + j <= parts; ++j) {
                const double u = i / double(parts);
                const double v = j / double(parts);
                const Vec3 point =
                    (1 - u - v) * from.vertices[a] + u * from.vertices[b] + v * from.vertices[c];
                largest = std::max(largest, bruteDistance(point, to));
            }
    return largest;
}

TEST(NearestTriangle, IsWhatBruteForceAndVtkFind)
{
    const TriangleMesh mesh = hills(12, 1);
    const NearestTriangle nearest(mesh);
    testing::VtkDistances vtk(mesh);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1, 2);
    for (int k = 0; k < 2000; ++k) {
        const Vec3 point(place(random), place(random), place(random));
        const double distance = nearest.to(point, static_cast<size_t>(k) % mesh.triangles.size()).distance;
        EXPECT_NEAR(distance, bruteDistance(point, mesh), 1e-14);
        EXPECT_NEAR(distance, vtk.to(point), 1e-9);
    }
}

TEST(MeshDistance, IsTheLargestOfAllPointsNotOfVerticesAlone)
{
    for (const unsigned seed : {2U, 3U, 4U}) {
        const TriangleMesh from = hills(5, seed);
        const TriangleMesh to = hills(7, seed + 10);
        const MeshDistance found = distanceFrom(from, to, 1e-9);
        const double brute = bruteLargest(from, to, 24);
        EXPECT_GE(found.largest + found.uncertainty, brute);
        EXPECT_NEAR(found.largest, brute, 0.01);
        EXPECT_LE(found.uncertainty, 1.01e-4 * found.largest);
        EXPECT_NEAR(bruteDistance(found.at, to), found.largest, 1e-14);
    }
    // A roof over a flat square: the vertices of the square are near, its middle is not.
    const TriangleMesh square{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    const TriangleMesh ring{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                            {{0, 1, 1}, {1, 2, 2}, {2, 3, 3}, {3, 0, 0}}};
    const MeshDistance hollow = distanceFrom(square, ring, 1e-6);
    EXPECT_NEAR(hollow.largest, 1, 1e-4);
    EXPECT_NEAR(hollow.mean, 1.0 / 3, 1e-3);
    EXPECT_NEAR(glm::length(hollow.at), 0, 1e-3);
}

TEST(MeshDistance, OfShiftedPlanesIsTheShift)
{
    TriangleMesh plane{{{0, 0, 0}, {3, 0, 0}, {3, 2, 0}, {0, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}};
    TriangleMesh shifted = plane;
    for (Vec3& vertex : shifted.vertices)
        vertex.z += 0.25;
    const MeshDistance up = distanceFrom(plane, shifted, 1e-9);
    EXPECT_NEAR(up.largest, 0.25, 1e-14);
    EXPECT_NEAR(up.mean, 0.25, 1e-12);
    EXPECT_NEAR(up.area, 6, 1e-12);
    EXPECT_EQ(distanceFrom(plane, plane, 1e-9).largest, 0);
}

TEST(SceneDistance, OfSpheresIsTheDifferenceOfTheirRadii)
{
    const SceneDistance found = distanceBetween(scaled("sphere", 1), scaled("sphere", 1.01)).value();
    EXPECT_NEAR(found.larger().largest, 0.01, found.uncertainty());
    EXPECT_NEAR(found.mean(), 0.01, found.uncertainty());
    EXPECT_LT(found.uncertainty(), 0.002);
    // The second one's numbers are in a unit a hundred times as long.
    const SceneDistance converted =
        distanceBetween(scaled("sphere", 1), scaled("sphere", 0.0101), 100).value();
    EXPECT_NEAR(converted.larger().largest, 0.01, converted.uncertainty());
}

TEST(SceneDistance, FromAModelToItselfIsNoneAndToItsMeshNoMoreThanItsDeviation)
{
    for (const char* name : {"torus", "hull"}) {
        const Scene model = findSample(name)->make();
        const SceneDistance none = distanceBetween(model, model).value();
        EXPECT_LE(none.larger().largest, none.uncertainty()) << name;
        const double deviation = 0.003 * model.bounds().diagonal();
        Scene mesh;
        mesh.addMesh(meshObject("", meshOf(model, deviation)));
        const SceneDistance found = distanceBetween(model, mesh).value();
        EXPECT_LE(found.larger().largest, deviation + found.uncertainty()) << name;
        EXPECT_GT(found.larger().largest, 0.1 * deviation) << name;
    }
}

// No mesh of few triangles stands for it.
TEST(SceneDistance, OfFifteenThousandKnotSpansFromAPlaneIsTheirHeight)
{
    const Scene knot = findSample("knot")->make();
    Box box;
    for (const auto& [id, object] : knot.objects())
        box.add(surfaceBounds(object->surface, object->transform));
    Scene plane;
    plane.addMesh(meshObject("", {{{-50, -50, 0}, {50, -50, 0}, {0, 90, 0}}, {{0, 1, 2}}}));
    const SceneDistance found = distanceBetween(knot, plane).value();
    EXPECT_NEAR(found.aToB.largest, std::max(-box.low.z, box.high.z), found.surfaces);
    EXPECT_LT(found.surfaces, 0.01);
}

TEST(SceneDistance, NeedsSomethingToCompare)
{
    EXPECT_FALSE(distanceBetween(Scene(), findSample("sphere")->make()));
    EXPECT_FALSE(distanceBetween(findSample("sphere")->make(), Scene()));
}

}  // namespace
}  // namespace knotspan
