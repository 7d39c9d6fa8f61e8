// That distances at all points of a surface, as a picture shows them, are those of closed forms and of brute
// force.
#include "model/mesh/deviation_map.h"

#include <functional>
#include <random>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/ksquad.h"
#include "model/geometry/primitives.h"
#include "model/scene/mesh_object.h"

namespace knotspan {
namespace {

// z at (x, y) = (i, j) / (count - 1), cubic.
NurbsSurface sheet(int count, const std::function<double(int, int)>& height)
{
    std::vector<ControlPoint> points;
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j)
            points.push_back({{i / (count - 1.0), j / (count - 1.0), height(i, j)}, 1});
    const KnotVector knots = KnotVector::clampedUniform(3, count - 3);
    return NurbsSurface::create(knots, knots, std::move(points)).value();
}

Scene sceneOf(const NurbsSurface& surface, const Mat4& transform = Mat4(1))
{
    Scene scene;
    scene.add({.transform = transform, .surface = surface});
    return scene;
}

// Two triangles around the middle of z = height.
TriangleMesh square(double size, double height)
{
    return {{{-size, -size, height}, {size, -size, height}, {size, size, height}, {-size, size, height}},
            {{0, 1, 2}, {0, 2, 3}}};
}

// visit(point in model space, the distance that a picture shows there)
template <class Visit>
void overPoints(const Scene& scene, const DeviationMap& map, const Visit& visit)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0, 1);
    for (const auto& [id, object] : scene.objects()) {
        const auto found = map.distances->find(id);
        ASSERT_NE(found, map.distances->end());
        const std::vector<KsQuad> quads = ksQuads(object->surface);
        ASSERT_EQ(found->second.cells.size(), quads.size());
        for (int k = 0; k < 200; ++k) {
            const size_t quad = random() % quads.size();
            const Vec2 t(share(random), share(random));
            const KnotVector& u = object->surface.knotsU();
            const KnotVector& v = object->surface.knotsV();
            const auto at = [](const KnotVector& knots, int span, double part) {
                return knots[span] + part * (knots[span + 1] - knots[span]);
            };
            const Vec3 own =
                evaluate(object->surface, at(u, quads[quad].spanU, t.x), at(v, quads[quad].spanV, t.y))
                    .position;
            visit(transformed(own, object->transform), found->second.at(quad, t));
        }
    }
}

TEST(DeviationMap, IsTheDistanceOfParallelPlanesEverywhere)
{
    const Scene plane = sceneOf(sheet(6, [](int, int) { return 0.0; }));
    Scene reference;
    reference.addMesh(meshObject("below", square(5, -0.25)));
    const DeviationMap map = deviationMap(plane, reference).value();
    EXPECT_NEAR(map.figures.largest, 0.25, 1e-12);
    EXPECT_NEAR(map.figures.mean, 0.25, 1e-12);
    EXPECT_LT(map.uncertainty(), 1e-3);
    EXPECT_LT(map.accuracy, 1e-6);
    overPoints(plane, map, [](const Vec3&, double shown) { EXPECT_NEAR(shown, 0.25, 1e-7); });
}

TEST(DeviationMap, IsTheDifferenceOfRadiiOfConcentricSpheres)
{
    const Scene inner = sceneOf(sphere({1, 2, 3}, 2));
    const Scene outer = sceneOf(sphere({1, 2, 3}, 3));
    for (const bool isInner : {true, false}) {
        const auto made = isInner ? deviationMap(inner, outer) : deviationMap(outer, inner);
        ASSERT_TRUE(made);
        const DeviationMap& map = *made;
        EXPECT_LT(map.uncertainty(), 0.01);
        EXPECT_NEAR(map.figures.largest, 1, map.uncertainty());
        EXPECT_NEAR(map.figures.mean, 1, map.bound);
        EXPECT_LT(map.accuracy, 0.01);
        overPoints(isInner ? inner : outer, map,
                   [&](const Vec3&, double shown) { EXPECT_NEAR(shown, 1, map.accuracy + 1e-6); });
    }
}

TEST(DeviationMap, IsTheHeightOverAPlaneWithinTheAccuracyThatItSays)
{
    const Mat4 turned = glm::rotate(glm::translate(Mat4(1), Vec3(3, 0, 1)), 0.4, Vec3(1, 1, 0));
    const Scene placed = sceneOf(torus({0, 0, 0}, 2, 0.5), turned);
    Scene reference;
    reference.addMesh(meshObject("below", square(50, -4)));
    const DeviationMap map = deviationMap(placed, reference).value();
    EXPECT_LT(map.accuracy, map.figures.largest / 250);
    double largest = 0;
    double worst = 0;
    overPoints(placed, map, [&](const Vec3& point, double shown) {
        largest = std::max(largest, point.z + 4);
        worst = std::max(worst, std::abs(shown - (point.z + 4)));
    });
    EXPECT_LE(worst, map.accuracy + 1e-6);
    EXPECT_GT(worst, 0) << "interpolated";
    EXPECT_LE(largest, map.figures.largest + map.uncertainty());
}

TEST(DeviationMap, OfAPlaneFromABumpyOneIsThatOfBruteForce)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> height(0.25, 0.5);
    const NurbsSurface bumpy = sheet(8, [&](int, int) { return height(random); });
    const Scene plane = sceneOf(sheet(4, [](int, int) { return 0.0; }));
    const DeviationMap map = deviationMap(plane, sceneOf(bumpy)).value();
    EXPECT_LT(map.accuracy, 0.005);
    constexpr int kCells = 400;
    std::vector<Vec3> points;
    for (int i = 0; i <= kCells; ++i)
        for (int j = 0; j <= kCells; ++j)
            points.push_back(evaluate(bumpy, i / double(kCells), j / double(kCells)).position);
    double furthest = 0;
    overPoints(plane, map, [&](const Vec3& point, double shown) {
        double nearest = 1e9;
        for (const Vec3& other : points)
            nearest = std::min(nearest, glm::distance(point, other));
        EXPECT_NEAR(shown, nearest, map.accuracy + 1e-4);
        furthest = std::max(furthest, nearest);
    });
    EXPECT_LE(furthest, map.figures.largest + map.uncertainty() + 1e-4);
    EXPECT_GT(furthest, 0.9 * map.figures.largest);
}

TEST(DeviationMap, LooksAtWhatIsVisibleAndTakesTheReferencesUnits)
{
    Scene measured = sceneOf(sheet(4, [](int, int) { return 0.0; }));
    const ObjectId hidden =
        measured.add({.visible = false, .surface = sheet(4, [](int, int) { return 9.0; })});
    measured.addMesh(meshObject("does not count", square(1, 77)));
    Scene reference;
    reference.addMesh(meshObject("in tens", square(5, 0.05)));
    MeshObject unseen = meshObject("unseen", square(5, 0));
    unseen.visible = false;
    reference.addMesh(unseen);
    const DeviationMap map = deviationMap(measured, reference, 10).value();
    EXPECT_NEAR(map.figures.largest, 0.5, 1e-9);
    EXPECT_EQ(map.distances->count(hidden), 0U);
}

TEST(DeviationMap, SaysWhyThereIsNone)
{
    const Scene sheets = sceneOf(sheet(4, [](int, int) { return 0.0; }));
    Scene onlyMeshes;
    onlyMeshes.addMesh(meshObject("flat", square(5, 0)));
    EXPECT_FALSE(deviationMap(sheets, {}));
    EXPECT_FALSE(deviationMap(onlyMeshes, sheets));
    EXPECT_FALSE(deviationMap(sheets, onlyMeshes, 1, [] { return true; }));
}

}  // namespace
}  // namespace knotspan
