// Snapping against looking at every place there is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/sculpting/snapping.h"
#include "model/sculpting/surface_snapping.h"
#include "tests/model/sculpting/sculpting_scene.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

Vec3 placeAt(const SceneObject& object, double u, double v)
{
    return transformed(evaluate(object.surface, u, v).position, object.transform);
}

// Of 40 x 40 places over the domain, or of 200 on each knot line.
double nearestByBruteForce(const SceneObject& object, const Vec3& place, SnapTarget target)
{
    const KnotVector& u = object.surface.knotsU();
    const KnotVector& v = object.surface.knotsV();
    const auto between = [](const KnotVector& knots, int k, int of) {
        return knots.domainStart() + (knots.domainEnd() - knots.domainStart()) * k / of;
    };
    double nearest = std::numeric_limits<double>::infinity();
    const auto look = [&](double a, double b) {
        nearest = std::min(nearest, glm::distance(placeAt(object, a, b), place));
    };
    if (target == SnapTarget::surface) {
        for (int i = 0; i <= 40; ++i)
            for (int j = 0; j <= 40; ++j)
                look(between(u, i, 40), between(v, j, 40));
        return nearest;
    }
    for (int k = 0; k <= 200; ++k) {
        for (int i = u.degree(); i <= u.controlPointCount(); ++i)
            look(u[i], between(v, k, 200));
        for (int j = v.degree(); j <= v.controlPointCount(); ++j)
            look(between(u, k, 200), v[j]);
    }
    return nearest;
}

}  // namespace

TEST(Snapping, GoesToTheNearestPointOfTheGrid)
{
    EXPECT_EQ(snappedToGrid({1.2, -0.7, 0.26}, 0.5), Vec3(1, -0.5, 0.5));
    EXPECT_EQ(snappedToGrid({1000.4, 2, -7.6}, 1), Vec3(1000, 2, -8));
    std::mt19937 random(5);
    for (int k = 0; k < 200; ++k) {
        const double step = randomBetween(random, 0.01, 3);
        const Vec3 place(randomBetween(random, -9, 9), randomBetween(random, -9, 9), 0.1);
        const Vec3 snapped = snappedToGrid(place, step);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_LE(std::abs(snapped[axis] - place[axis]), step / 2 * (1 + 1e-12));
        EXPECT_EQ(snappedToGrid(snapped, step), snapped);
    }
}

TEST(Snapping, GoesToTheNearestControlPointThatDoesNotMove)
{
    std::mt19937 random(6);
    Scene scene = sceneOf({symmetricSheet(), symmetricSheet(6, 5)});
    SceneObject moved = *scene.find(kSecond);
    moved.transform = anyTransform();
    scene.exchange(kSecond, std::make_shared<SceneObject>(moved));
    const PointSelection moving = rowOf(scene, kFirst, 4);
    const PointSnap snap(scene, {kFirst, kSecond, ObjectId{8}}, moving);
    size_t found = 0;
    for (int round = 0; round < 300; ++round) {
        const Vec3 place(randomBetween(random, -6, 6), randomBetween(random, -3, 9),
                         randomBetween(random, -2, 6));
        const double reach = randomBetween(random, 0, 4);
        double nearest = std::numeric_limits<double>::infinity();
        for (const ObjectId id : {kFirst, kSecond})
            for (int i = 0; i < scene.find(id)->surface.countU(); ++i)
                for (int j = 0; j < scene.find(id)->surface.countV(); ++j)
                    if (!moving.contains({id, {i, j}}))
                        nearest = std::min(nearest, glm::distance(placeIn(scene, id, i, j), place));
        const auto snapped = snap.nearest(place, reach);
        ASSERT_EQ(snapped.has_value(), nearest <= reach);
        if (!snapped)
            continue;
        ++found;
        EXPECT_EQ(snapped->distance, nearest);
        EXPECT_EQ(snapped->position,
                  placeIn(scene, snapped->point.object, snapped->point.index.i, snapped->point.index.j));
        EXPECT_FALSE(moving.contains(snapped->point));
    }
    EXPECT_GT(found, 50U);
}

TEST(Snapping, OntoASphereIsAlongItsRadius)
{
    std::mt19937 random(7);
    const Scene scene = sceneOf({sphere({1, 2, 3}, 2)});
    const SurfaceSnap snap(scene, {kFirst}, SnapTarget::surface);
    for (int round = 0; round < 100; ++round) {
        const Vec3 away(randomBetween(random, -3, 3), randomBetween(random, -3, 3),
                        randomBetween(random, -3, 3));
        const double expected = std::abs(glm::length(away) - 2);
        const auto place = snap.nearest(Vec3(1, 2, 3) + away, 1);
        ASSERT_EQ(place.has_value(), expected <= 1) << round;
        if (!place)
            continue;
        EXPECT_NEAR(place->distance, expected, 1e-12);
        EXPECT_LE(glm::distance(place->position, Vec3(1, 2, 3) + 2.0 * glm::normalize(away)), 1e-6);
    }
}

TEST(Snapping, FindsNoPlaceFurtherThanBruteForceDoes)
{
    std::mt19937 random(8);
    for (int round = 0; round < 24; ++round) {
        Scene scene = sceneOf(randomSurface(random, {.spans = 4, .rational = round % 4 > 1}));
        SceneObject object = *scene.find(kFirst);
        object.transform = round % 3 == 0 ? anyTransform() : Mat4(1.0);
        scene.exchange(kFirst, std::make_shared<SceneObject>(object));
        const SnapTarget target = round % 2 == 0 ? SnapTarget::surface : SnapTarget::knotLines;
        const SurfaceSnap snap(scene, {kFirst, ObjectId{5}}, target);
        const Box box = object.bounds();
        for (int k = 0; k < 8; ++k) {
            const Vec3 position(randomBetween(random, box.low.x, box.high.x),
                                randomBetween(random, box.low.y, box.high.y),
                                randomBetween(random, box.low.z, box.high.z));
            const auto place = snap.nearest(position, 1e9);
            ASSERT_TRUE(place);
            EXPECT_LE(place->distance, nearestByBruteForce(object, position, target)) << round;
            EXPECT_EQ(place->position, placeAt(object, place->u, place->v));
            EXPECT_EQ(place->distance, glm::distance(place->position, position));
            const auto isKnot = [](const KnotVector& knots, double value) {
                return std::count(knots.values().begin(), knots.values().end(), value) > 0;
            };
            EXPECT_TRUE(target == SnapTarget::surface || isKnot(object.surface.knotsU(), place->u) ||
                        isKnot(object.surface.knotsV(), place->v));
            EXPECT_FALSE(snap.nearest(position, place->distance * 0.99));
        }
    }
}

}  // namespace knotspan::testing
