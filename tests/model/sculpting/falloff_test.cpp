// Falloff against looking at every pair of points, and against distances relaxed until nothing changes.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/primitives.h"
#include "model/sculpting/falloff.h"
#include "model/sculpting/nearest_points.h"
#include "model/sculpting/net_distance.h"
#include "tests/model/sculpting/sculpting_scene.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

constexpr FalloffShape kShapes[] = {FalloffShape::smooth, FalloffShape::sphere, FalloffShape::linear,
                                    FalloffShape::sharp, FalloffShape::constant};

double expectedShare(FalloffShape shape, double x)
{
    if (x >= 1)
        return 0;
    switch (shape) {
    case FalloffShape::smooth:
        return 3 * std::pow(1 - x, 2) - 2 * std::pow(1 - x, 3);
    case FalloffShape::sphere:
        return std::sqrt(1 - x * x);
    case FalloffShape::linear:
        return 1 - x;
    case FalloffShape::sharp:
        return std::pow(1 - x, 2);
    case FalloffShape::constant:
        break;
    }
    return 1;
}

Scene transformedScene(std::mt19937& random)
{
    Scene scene = sceneOf(randomSurface(random, {}));
    SceneObject other = *scene.find(kFirst);
    other.surface = randomSurface(random, {.spans = 5});
    other.transform = anyTransform();
    scene.add(other);
    return scene;
}

PointSelection someOf(std::mt19937& random, const Scene& scene, ObjectId id, int count)
{
    PointSelection selection;
    const NurbsSurface& surface = scene.find(id)->surface;
    for (int k = 0; k < count; ++k)
        selection.add(
            pointOf(scene, {id,
                            {static_cast<int>(random() % static_cast<unsigned>(surface.countU())),
                             static_cast<int>(random() % static_cast<unsigned>(surface.countV()))}}));
    return selection;
}

// Each point's distance lessened by way of its neighbours until none can be.
std::vector<double> relaxed(const SceneObject& object, const std::vector<ControlPointIndex>& from, bool steps)
{
    const NetSize size = netSizeOf(object.surface);
    std::vector<double> distances(size.count(), std::numeric_limits<double>::infinity());
    for (const ControlPointIndex index : from)
        distances[size.place(index)] = 0;
    for (bool changed = true; changed;) {
        changed = false;
        for (size_t a = 0; a < size.count(); ++a)
            for (size_t b = 0; b < size.count(); ++b) {
                const ControlPointIndex p = size.indexAt(a);
                const ControlPointIndex q = size.indexAt(b);
                if (std::abs(p.i - q.i) + std::abs(p.j - q.j) != 1)
                    continue;
                const double way =
                    steps ? 1 : glm::distance(controlPointInModel(object, p), controlPointInModel(object, q));
                if (distances[a] + way < distances[b]) {
                    distances[b] = distances[a] + way;
                    changed = true;
                }
            }
    }
    return distances;
}

double shareOf(const Followers& followers, ObjectId id, ControlPointIndex index)
{
    const auto found = followers.find(id);
    if (found != followers.end())
        for (const Follower& follower : found->second)
            if (follower.index == index)
                return follower.share;
    return 0;
}

}  // namespace

TEST(Falloff, HasBlendersShapes)
{
    for (const FalloffShape shape : kShapes) {
        double before = 1;
        for (int k = 0; k <= 120; ++k) {
            const double share = falloffShare(shape, k * 0.02, 2);
            EXPECT_NEAR(share, expectedShare(shape, k * 0.01), 1e-7) << k;
            EXPECT_LE(share, before);
            before = share;
        }
        EXPECT_EQ(falloffShare(shape, 0, 2), 1);
        EXPECT_EQ(falloffShare(shape, 0, 0), 1);
        EXPECT_EQ(falloffShare(shape, 2, 2), 0);
        EXPECT_EQ(falloffShare(shape, std::nan(""), 2), 0);
        EXPECT_EQ(falloffShare(shape, 1, std::nan("")), 0);
    }
}

TEST(Falloff, InSpaceIsThatOfTheNearestSelectedPoint)
{
    std::mt19937 random(11);
    size_t between = 0;
    for (int round = 0; round < 60; ++round) {
        const Scene scene = transformedScene(random);
        PointSelection selection = someOf(random, scene, kFirst, 1 + round % 9);
        if (round % 3 == 0)
            selection.add(someOf(random, scene, kSecond, 3));
        const Falloff falloff{randomBetween(random, 0.1, 4), kShapes[round % 5], FalloffDistance::space};
        const Followers followers = followersOf(scene, selection, falloff, {kSecond});
        for (const auto& [id, object] : scene.objects())
            for (int i = 0; i < object->surface.countU(); ++i)
                for (int j = 0; j < object->surface.countV(); ++j) {
                    double nearest = std::numeric_limits<double>::infinity();
                    for (const auto& [other, selected] : selection.objects())
                        for (const ControlPointIndex index : selected.points)
                            nearest =
                                std::min(nearest, glm::distance(placeIn(scene, id, i, j),
                                                                placeIn(scene, other, index.i, index.j)));
                    const double share = falloffShare(falloff.shape, nearest, falloff.radius);
                    EXPECT_EQ(shareOf(followers, id, {i, j}), share) << round;
                    between += share > 0 && share < 1 ? 1 : 0;
                }
    }
    EXPECT_GT(between, 300U);
}

TEST(Falloff, AlongTheNetIsTheShortestWay)
{
    std::mt19937 random(12);
    size_t between = 0;
    for (int round = 0; round < 30; ++round) {
        const Scene scene = transformedScene(random);
        const ObjectId id = round % 2 == 0 ? kFirst : kSecond;
        const SharedObject object = scene.find(id);
        const PointSelection selection = someOf(random, scene, id, 1 + round % 4);
        const std::vector<ControlPointIndex>& points = selection.objects().at(id).points;
        const bool steps = round % 4 < 2;
        const std::vector<double> expected = relaxed(*object, points, steps);
        EXPECT_EQ(distancesAlongNet(*object, points, steps ? NetMeasure::steps : NetMeasure::lengths),
                  expected);
        const Falloff falloff{steps ? 2.5 : 3.5, kShapes[round % 5],
                              steps ? FalloffDistance::netSteps : FalloffDistance::netLengths};
        const Followers followers = followersOf(scene, selection, falloff);
        EXPECT_EQ(followers.size(), 1U);
        const NetSize size = netSizeOf(object->surface);
        for (size_t place = 0; place < size.count(); ++place) {
            const double share = falloffShare(falloff.shape, expected[place], falloff.radius);
            EXPECT_EQ(shareOf(followers, id, size.indexAt(place)), share);
            between += share > 0 && share < 1 ? 1 : 0;
        }
    }
    EXPECT_GT(between, 100U);
}

TEST(Falloff, WithoutARadiusMovesTheSelectionAlone)
{
    std::mt19937 random(13);
    const Scene scene = transformedScene(random);
    const PointSelection selection = rowOf(scene, kSecond, 2);
    for (const double radius : {0.0, -1.0, std::nan("")}) {
        const Followers followers = followersOf(scene, selection, {.radius = radius}, {kFirst});
        ASSERT_EQ(followers.size(), 1U);
        EXPECT_EQ(followers.at(kSecond).size(), selection.size());
        for (const Follower& follower : followers.at(kSecond))
            EXPECT_EQ(follower.share, 1);
    }
    EXPECT_TRUE(followersOf(scene, {}, {.radius = 5}, {kFirst, kSecond}).empty());
}

TEST(Falloff, GoesOverTheSeamOfAClosedNet)
{
    const Scene scene = sceneOf({torus({0, 0, 0}, 3, 1)});
    const NurbsSurface& surface = scene.find(kFirst)->surface;
    const int last = surface.countU() - 1;
    const Falloff falloff{1.5, FalloffShape::linear, FalloffDistance::netSteps};
    const Followers followers = followersOf(scene, pointOf(scene, {kFirst, {0, 3}}), falloff);
    EXPECT_EQ(shareOf(followers, kFirst, {last, 3}), 1);
    EXPECT_EQ(shareOf(followers, kFirst, {last - 1, 3}), shareOf(followers, kFirst, {1, 3}));
    EXPECT_GT(shareOf(followers, kFirst, {1, 3}), 0);
}

TEST(NearestPoints, GivesTheFirstOfEquallyNearOnes)
{
    std::mt19937 random(14);
    for (int round = 0; round < 50; ++round) {
        std::vector<Vec3> points;
        const auto whole = [&] { return std::floor(randomBetween(random, 0, 4)); };
        for (int k = 0; k < 1 + round * 3; ++k)
            points.emplace_back(whole(), whole(), round % 2 == 0 ? 0 : whole());
        const NearestPoints tree(points);
        for (int k = 0; k < 60; ++k) {
            const Vec3 place(whole() + 0.5 * (k % 2), whole(), whole());
            const double reach = k % 5;
            std::vector<size_t> within;
            size_t best = points.size();
            for (size_t p = 0; p < points.size(); ++p) {
                if (glm::distance(points[p], place) > reach)
                    continue;
                within.push_back(p);
                if (best == points.size() ||
                    glm::distance(points[p], place) < glm::distance(points[best], place))
                    best = p;
            }
            EXPECT_EQ(tree.within(place, reach), within);
            const auto found = tree.nearest(place, reach);
            ASSERT_EQ(found.has_value(), !within.empty());
            if (found) {
                EXPECT_EQ(found->index, best);
                EXPECT_EQ(found->distance, glm::distance(points[best], place));
            }
        }
    }
}

// Every point against every selected one would be 2.5e9 distances.
TEST(Falloff, OfAHundredThousandPointsTakesAMoment)
{
    const NurbsSurface large = netOfPlaces(400, 250, [](int i, int j) {
        return Vec3(0.1 * i, 0.1 * j, std::sin(0.05 * i) * std::cos(0.07 * j));
    });
    const Scene scene = sceneOf({large});
    std::vector<ControlPointIndex> points;
    for (int i = 0; i < 400; i += 2)
        for (int j = i % 4 / 2; j < 250; j += 2)
            points.push_back({i, j});
    const PointSelection selection(kFirst, {400, 250}, points);
    for (const auto distance : {FalloffDistance::space, FalloffDistance::netLengths}) {
        const auto start = std::chrono::steady_clock::now();
        const Followers followers = followersOf(scene, selection, {30, FalloffShape::smooth, distance});
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        RecordProperty(distance == FalloffDistance::space ? "seconds_space" : "seconds_net",
                       std::to_string(seconds));
        EXPECT_EQ(followers.at(kFirst).size(), 100000U);
        EXPECT_LT(seconds, 3);
    }
}

}  // namespace knotspan::testing
