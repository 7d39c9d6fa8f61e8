// Drags: where the points go, and that nothing else changes.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/sculpting/net_directions.h"
#include "model/sculpting/point_drag.h"
#include "tests/model/sculpting/sculpting_scene.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

Scene twoObjects(std::mt19937& random)
{
    Scene scene = sceneOf(randomSurface(random, {.rational = true}));
    SceneObject other = *scene.find(kFirst);
    other.surface = randomSurface(random, {.spans = 5, .rational = true});
    other.transform = anyTransform();
    scene.add(other);
    scene.add(other);
    return scene;
}

PointDrag begun(const Scene& scene, const PointSelection& selection, const DragSettings& settings)
{
    auto drag = PointDrag::begin(scene, selection, settings);
    EXPECT_TRUE(drag) << drag.error().sentence();
    return *std::move(drag);
}

Vec3 anyVector(std::mt19937& random)
{
    return {randomBetween(random, -2, 2), randomBetween(random, -2, 2), randomBetween(random, -2, 2)};
}

double shareOf(const PointDrag& drag, ObjectId id, ControlPointIndex index)
{
    const auto found = drag.followers().find(id);
    if (found != drag.followers().end())
        for (const Follower& follower : found->second)
            if (follower.index == index)
                return follower.share;
    return 0;
}

}  // namespace

TEST(PointDrag, MovesSelectedPointsWithTheHandAndOthersByTheirShare)
{
    std::mt19937 random(21);
    for (int round = 0; round < 40; ++round) {
        const Scene start = twoObjects(random);
        PointSelection selection = rowOf(start, kFirst, 1);
        selection.add(pointOf(start, {kSecond, {2, 3}}));
        DragSettings settings;
        settings.falloff = {round % 2 == 0 ? 0.0 : 1.5, FalloffShape::smooth, FalloffDistance::space};
        const PointDrag drag = begun(start, selection, settings);
        const Vec3 by = anyVector(random);
        const Scene scene = applied(start, *drag.moved(by));
        EXPECT_EQ(scene.find(ObjectId{2}), start.find(ObjectId{2}))
            << "what is not touched is the same pointer";
        for (const auto& [id, object] : start.objects()) {
            const NurbsSurface& after = scene.find(id)->surface;
            EXPECT_EQ(after.knotsU(), object->surface.knotsU());
            for (int i = 0; i < after.countU(); ++i)
                for (int j = 0; j < after.countV(); ++j) {
                    const double share = shareOf(drag, id, {i, j});
                    EXPECT_TRUE(share == 1 || !selection.contains({id, {i, j}}));
                    EXPECT_LE(glm::distance(placeIn(scene, id, i, j), placeIn(start, id, i, j) + share * by),
                              1e-12);
                    EXPECT_EQ(after.controlPoint(i, j).weight, object->surface.controlPoint(i, j).weight);
                    EXPECT_TRUE(share > 0 || after.controlPoint(i, j) == object->surface.controlPoint(i, j));
                    EXPECT_EQ(drag.moving().contains({id, {i, j}}), share > 0);
                }
        }
    }
}

TEST(PointDrag, UndoneReturnsEveryBit)
{
    std::mt19937 random(22);
    const Scene start = twoObjects(random);
    DragSettings settings;
    settings.falloff.radius = 3;
    settings.others = {kFirst, kSecond};
    const PointDrag drag = begun(start, rowOf(start, kSecond, 2), settings);
    Scene scene = start;
    Edit all;
    for (int event = 0; event < 5; ++event) {
        Edit edit = *drag.moved(anyVector(random));
        edit.applyTo(scene);
        all.absorb(edit);
    }
    EXPECT_FALSE(scene == start);
    all.applyTo(scene);
    EXPECT_EQ(scene.objects(), start.objects()) << "the same pointers";
    const Scene back = applied(applied(start, *drag.moved({1, 2, 3})), *drag.moved(Vec3(0)));
    EXPECT_EQ(back.objects(), start.objects()) << "a hand that comes back leaves nothing";
}

TEST(PointDrag, KeepsToTheAxesOfTheModel)
{
    std::mt19937 random(23);
    const Scene start = twoObjects(random);
    const PointSelection selection = pointOf(start, {kFirst, {1, 2}});
    const Vec3 from = placeIn(start, kFirst, 1, 2);
    for (const int axis : {0, 1, 2}) {
        DragSettings settings;
        settings.axis = axis == 0 ? DragAxis::x : axis == 1 ? DragAxis::y : DragAxis::z;
        const PointDrag drag = begun(start, selection, settings);
        const Vec3 by(0.5, -0.75, 1.25);
        Vec3 expected = from;
        expected[axis] += by[axis];
        EXPECT_EQ(placeIn(applied(start, *drag.moved(by)), kFirst, 1, 2), expected);
        EXPECT_EQ(placeIn(applied(start, *drag.movedAlong(by[axis])), kFirst, 1, 2), expected);
    }
}

TEST(PointDrag, KeepsToTheSurfacesOwnDirections)
{
    // On a slanted plane they are known.
    const Vec3 u = glm::normalize(Vec3(1, 2, 0));
    const Vec3 v = glm::normalize(Vec3(0, 1, 3));
    Scene start = sceneOf({netOfPlaces(6, 5, [&](int i, int j) { return 0.7 * i * u + 0.4 * j * v; })});
    const Vec3 expected[] = {u, v, glm::normalize(glm::cross(u, v))};
    for (const int axis : {0, 1, 2})
        for (const bool own : {false, true}) {
            DragSettings settings;
            settings.axis = axis == 0 ? DragAxis::u : axis == 1 ? DragAxis::v : DragAxis::normal;
            settings.eachItsOwn = own;
            settings.falloff.radius = 2;
            const PointDrag drag = begun(start, columnOf(start, kFirst, 2), settings);
            EXPECT_LE(glm::distance(drag.direction(), expected[axis]), 1e-14);
            const Vec3 across = glm::cross(expected[axis], Vec3(0.3, 1, -1));
            for (const auto& [id, shifts] : drag.shifts(2.0 * expected[axis] + across))
                for (const PointShift& shift : shifts)
                    EXPECT_LE(glm::distance(shift.by, 2 * shareOf(drag, id, shift.index) * expected[axis]),
                              1e-13);
        }
}

TEST(PointDrag, AlongOwnNormalsFollowsTheSurfaceThere)
{
    std::mt19937 random(24);
    for (int round = 0; round < 20; ++round) {
        Scene start = sceneOf(randomSurface(random, {.spans = round == 0 ? 30 : 4, .rational = true}));
        SceneObject object = *start.find(kFirst);
        object.transform = round % 2 == 0 ? Mat4(1.0) : anyTransform();
        start.exchange(kFirst, std::make_shared<SceneObject>(object));
        DragSettings settings;
        settings.axis = DragAxis::normal;
        settings.eachItsOwn = true;
        const PointDrag drag = begun(start, netOf(start, kFirst), settings);
        const Scene scene = applied(start, *drag.movedAlong(0.5));
        const NurbsSurface& surface = object.surface;
        const auto greville = [](const KnotVector& knots, int k) {
            long double sum = 0;
            for (int r = 1; r <= knots.degree(); ++r)
                sum += knots[k + r];
            return static_cast<double>(sum / knots.degree());
        };
        for (int i = 0; i < surface.countU(); ++i)
            for (int j = 0; j < surface.countV(); ++j) {
                const SurfacePoint at =
                    evaluate(surface, greville(surface.knotsU(), i), greville(surface.knotsV(), j));
                const glm::dmat3 linear(object.transform);
                const Vec3 normal = glm::normalize(glm::cross(linear * at.du, linear * at.dv));
                EXPECT_LE(
                    glm::distance(placeIn(scene, kFirst, i, j), placeIn(start, kFirst, i, j) + 0.5 * normal),
                    1e-9)
                    << round;
            }
    }
}

TEST(PointDrag, KeepsSeamsAndPolesTogether)
{
    const Scene start = sceneOf({sphere({0, 0, 0}, 2)});
    const NurbsSurface& surface = start.find(kFirst)->surface;
    for (const DragAxis axis : {DragAxis::free, DragAxis::v, DragAxis::normal}) {
        DragSettings settings;
        settings.axis = axis;
        settings.eachItsOwn = true;
        settings.falloff.radius = 2.5;
        const PointDrag drag = begun(start, pointOf(start, {kFirst, {0, 2}}), settings);
        const Scene scene =
            applied(start, axis == DragAxis::free ? *drag.moved({0.1, 0.7, 0.4}) : *drag.movedAlong(0.5));
        EXPECT_GT(largestDifference(scene, start), 0.4);
        for (int j = 0; j < surface.countV(); ++j)
            EXPECT_EQ(placeIn(scene, kFirst, 0, j), placeIn(scene, kFirst, surface.countU() - 1, j));
        for (int i = 1; i < surface.countU(); ++i)
            EXPECT_LE(glm::distance(placeIn(scene, kFirst, i, 0), placeIn(scene, kFirst, 0, 0)), 1e-15);
    }
}

TEST(PointDrag, RefusesWhatHasNoDirectionOrNoEnd)
{
    const Scene scene = sceneOf({sphere({0, 0, 0}, 2)});
    DragSettings settings;
    settings.axis = DragAxis::u;
    const auto round = PointDrag::begin(scene, pointOf(scene, {kFirst, {3, 0}}), settings);
    ASSERT_FALSE(round);
    EXPECT_NE(round.error().sentence().find("no such direction"), std::string::npos);
    const PointDrag drag = begun(scene, pointOf(scene, {kFirst, {3, 2}}), {});
    const auto edit = drag.moved({std::numeric_limits<double>::infinity(), 0, 0});
    ASSERT_FALSE(edit);
    EXPECT_NE(edit.error().sentence().find("infinitely far"), std::string::npos);
}

}  // namespace knotspan::testing
