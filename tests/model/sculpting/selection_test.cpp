// Selections against sets and against looking at every point by itself.
#include <gtest/gtest.h>

#include <set>

#include "model/geometry/primitives.h"
#include "model/sculpting/screen_selection.h"
#include "model/sculpting/twins.h"
#include "tests/model/sculpting/sculpting_scene.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

constexpr NetSize kNet{6, 8};
using Set = std::set<std::pair<int, int>>;

Set randomSet(std::mt19937& random, double share, NetSize net = kNet)
{
    Set set;
    for (int i = 0; i < net.countU; ++i)
        for (int j = 0; j < net.countV; ++j)
            if (randomBetween(random, 0, 1) < share)
                set.emplace(i, j);
    return set;
}

PointSelection selectionOf(const Set& set, ObjectId id = kFirst, NetSize net = kNet)
{
    std::vector<ControlPointIndex> points;
    for (auto entry = set.rbegin(); entry != set.rend(); ++entry)
        points.push_back({entry->first, entry->second});
    return {id, net, points};
}

Set setOf(const PointSelection& selection, ObjectId id = kFirst)
{
    Set set;
    const auto found = selection.objects().find(id);
    if (found != selection.objects().end())
        for (const ControlPointIndex index : found->second.points)
            set.emplace(index.i, index.j);
    return set;
}

bool hasNeighbourIn(const Set& set, int i, int j, bool wanted)
{
    for (const auto& [di, dj] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}})
        if (kNet.contains({i + di, j + dj}) && (set.count({i + di, j + dj}) != 0) == wanted)
            return true;
    return false;
}

// Crossings of the way to a place far outside in an odd direction.
bool isInside(const Vec2& place, const std::vector<Vec2>& polygon)
{
    const Vec2 outside(12345.678, 98765.432);
    const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    };
    bool inside = false;
    for (size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k];
        const Vec2 b = polygon[(k + 1) % polygon.size()];
        if (side(place, outside, a) != side(place, outside, b) && side(a, b, place) != side(a, b, outside))
            inside = !inside;
    }
    return inside;
}

}  // namespace

TEST(PointSelection, AddsRemovesAndTogglesLikeSets)
{
    std::mt19937 random(1);
    for (int round = 0; round < 200; ++round) {
        const Set a = randomSet(random, 0.3);
        const Set b = randomSet(random, round % 7 == 0 ? 0 : 0.4);
        Set sum = a;
        sum.insert(b.begin(), b.end());
        Set rest;
        Set either;
        for (const auto& point : sum) {
            if (b.count(point) == 0)
                rest.insert(point);
            if (a.count(point) != b.count(point))
                either.insert(point);
        }
        PointSelection added = selectionOf(a);
        added.add(selectionOf(b));
        EXPECT_EQ(setOf(added), sum);
        EXPECT_EQ(added.size(), sum.size());
        PointSelection removed = selectionOf(a);
        removed.remove(selectionOf(b));
        EXPECT_EQ(removed, selectionOf(rest));
        PointSelection toggled = selectionOf(a);
        toggled.toggle(selectionOf(b));
        EXPECT_EQ(toggled, selectionOf(either));
        toggled.toggle(selectionOf(b));
        EXPECT_EQ(toggled, selectionOf(a));
        for (int k = 0; k < 10; ++k) {
            const ControlPointIndex index{k % kNet.countU, k % kNet.countV};
            EXPECT_EQ(added.contains({kFirst, index}), sum.count({index.i, index.j}) != 0);
            EXPECT_FALSE(added.contains({kSecond, index}));
        }
    }
}

TEST(PointSelection, IsInOneOrderHoweverItWasMade)
{
    const PointSelection a(kFirst, kNet, {{3, 1}, {0, 2}, {3, 0}, {0, 2}});
    const std::vector<ControlPointIndex> sorted{{0, 2}, {3, 0}, {3, 1}};
    EXPECT_EQ(a.objects().at(kFirst).points, sorted);
    PointSelection b(kFirst, kNet, {{3, 0}});
    b.add({kFirst, kNet, {{3, 1}, {0, 2}}});
    EXPECT_EQ(a, b);
    b.remove(a);
    EXPECT_EQ(b, PointSelection());
    EXPECT_TRUE(b.isEmpty());
}

TEST(PointSelection, TakesRowsColumnsAndNets)
{
    const Scene scene = sceneOf({symmetricSheet(9, 7), symmetricSheet(5, 6)});
    EXPECT_EQ(setOf(rowOf(scene, kSecond, 4), kSecond),
              (Set{{4, 0}, {4, 1}, {4, 2}, {4, 3}, {4, 4}, {4, 5}}));
    EXPECT_EQ(setOf(columnOf(scene, kSecond, 5), kSecond), (Set{{0, 5}, {1, 5}, {2, 5}, {3, 5}, {4, 5}}));
    EXPECT_EQ(netOf(scene, kFirst).size(), 63U);
    PointSelection rows;
    for (int i = 0; i < 9; ++i)
        rows.add(rowOf(scene, kFirst, i));
    EXPECT_EQ(rows, netOf(scene, kFirst));
    EXPECT_TRUE(rowOf(scene, kSecond, 5).isEmpty());
    EXPECT_TRUE(columnOf(scene, kFirst, -1).isEmpty());
    EXPECT_TRUE(netOf(scene, ObjectId{9}).isEmpty());
    EXPECT_TRUE(pointOf(scene, {kFirst, {9, 0}}).isEmpty());
    EXPECT_EQ(setOf(pointOf(scene, {kFirst, {8, 6}})), (Set{{8, 6}}));
}

TEST(PointSelection, GrowsAndShrinksByNeighbours)
{
    std::mt19937 random(2);
    for (int round = 0; round < 100; ++round) {
        const Set set = randomSet(random, round % 2 == 0 ? 0.2 : 0.8);
        Set larger = set;
        Set smaller;
        for (int i = 0; i < kNet.countU; ++i)
            for (int j = 0; j < kNet.countV; ++j) {
                if (hasNeighbourIn(set, i, j, true))
                    larger.emplace(i, j);
                if (set.count({i, j}) != 0 && !hasNeighbourIn(set, i, j, false))
                    smaller.emplace(i, j);
            }
        const PointSelection selection = selectionOf(set);
        EXPECT_EQ(setOf(grown(selection)), larger);
        EXPECT_EQ(setOf(shrunk(selection)), smaller);
        PointSelection back = selection;
        back.remove(shrunk(grown(selection)));
        EXPECT_TRUE(back.isEmpty()) << "shrinking what was grown loses nothing";
    }
    Set rectangle;
    for (int i = 2; i < 4; ++i)
        for (int j = 2; j < 6; ++j)
            rectangle.emplace(i, j);
    EXPECT_EQ(shrunk(grown(selectionOf(rectangle))), selectionOf(rectangle));
}

TEST(PointSelection, InvertsWithinItsObjectsOrGivenOnes)
{
    const Scene scene = sceneOf({symmetricSheet(9, 7), symmetricSheet(5, 6)});
    const PointSelection row = rowOf(scene, kFirst, 3);
    const PointSelection rest = inverted(row);
    EXPECT_EQ(rest.size(), 63U - 7U);
    EXPECT_FALSE(rest.contains({kFirst, {3, 2}}));
    EXPECT_EQ(inverted(rest), row);
    EXPECT_TRUE(inverted(netOf(scene, kFirst)).isEmpty());
    const PointSelection all = inverted(row, scene, {kFirst, kSecond});
    EXPECT_EQ(all.size(), 63U - 7U + 30U);
    EXPECT_EQ(inverted(all, scene, {kFirst, kSecond}), row);
    EXPECT_EQ(inverted(row, scene, {kSecond}), netOf(scene, kSecond));
    EXPECT_EQ(inverted({}, scene, {kSecond}), netOf(scene, kSecond));
}

TEST(PointSelection, LetsGoOfNetsThatChangedShape)
{
    Scene scene = sceneOf({symmetricSheet(9, 7), symmetricSheet(5, 6)});
    PointSelection selection = rowOf(scene, kFirst, 3);
    selection.add(rowOf(scene, kSecond, 2));
    PointSelection kept = selection;
    kept.keepOnly(scene);
    EXPECT_EQ(kept, selection);
    scene.exchange(kFirst, sceneOf({symmetricSheet(7, 9)}).find(kFirst));
    kept.keepOnly(scene);
    EXPECT_EQ(kept, rowOf(scene, kSecond, 2));
    selection.add(rowOf(scene, kFirst, 0));
    EXPECT_EQ(selection.objects().at(kFirst).points.size(), 9U) << "the newer net is right";
    scene.exchange(kSecond, nullptr);
    kept.keepOnly(scene);
    EXPECT_TRUE(kept.isEmpty());
}

TEST(PointSelection, TakesWhatIsOnePointOfTheShapeAlong)
{
    const Scene scene = sceneOf({sphere({0, 0, 0}, 2), symmetricSheet(), torus({0, 0, 0}, 3, 1)});
    const ObjectId ring{2};
    const auto sizes = [&](ObjectId id) { return netSizeOf(scene.find(id)->surface); };
    const NetSize ball = sizes(kFirst);
    const NetSize tube = sizes(ring);
    PointSelection seam = withTwins(scene, pointOf(scene, {kFirst, {ball.countU - 1, 3}}));
    EXPECT_EQ(setOf(seam), (Set{{0, 3}, {ball.countU - 1, 3}}));
    EXPECT_EQ(withTwins(scene, pointOf(scene, {kFirst, {5, 0}})), columnOf(scene, kFirst, 0)) << "a pole";
    EXPECT_EQ(withTwins(scene, pointOf(scene, {ring, {0, 0}})).size(), 4U);
    EXPECT_TRUE(withTwins(scene, pointOf(scene, {ring, {0, 0}}))
                    .contains({ring, {tube.countU - 1, tube.countV - 1}}));
    for (const ScenePoint point : {ScenePoint{kSecond, {0, 0}}, ScenePoint{kFirst, {4, 4}}})
        EXPECT_EQ(withTwins(scene, pointOf(scene, point)), pointOf(scene, point));
}

TEST(ScreenSelection, TakesWhatIsInTheBoxAndBeforeTheEye)
{
    const Scene scene = sceneOf({symmetricSheet(9, 7)});
    const auto nets = projected(scene, {kFirst, ObjectId{7}}, [](const Vec3& place) {
        return place.x > 3.5 ? std::nullopt : std::optional(Vec2(place.x, place.y));
    });
    ASSERT_EQ(nets.size(), 1U);
    const PointSelection chosen = insideBox(nets, {10, -10}, {-4, 10});
    EXPECT_EQ(chosen.size(), 8U * 7U) << "the border counts, what is behind the eye does not";
    EXPECT_EQ(insideBox(nets, {-4, -10}, {10, 10}), chosen) << "whichever corners";
    EXPECT_EQ(insideBox(nets, {-0.5, -10}, {0.5, 10}), rowOf(scene, kFirst, 4));
    EXPECT_TRUE(insideBox(nets, {0.1, 0}, {0.2, 1}).isEmpty());
}

TEST(ScreenSelection, LassoIsEvenOdd)
{
    std::mt19937 random(3);
    size_t inside = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<Vec2> polygon;
        const int corners = round < 3 ? round : 3 + round * round / 6;
        for (int k = 0; k < corners; ++k)
            polygon.emplace_back(randomBetween(random, -40, 300), randomBetween(random, 10, 200));
        const Lasso lasso(polygon);
        for (int k = 0; k < 400; ++k) {
            const Vec2 place(randomBetween(random, -60, 320), randomBetween(random, 0, 210));
            EXPECT_EQ(lasso.contains(place), isInside(place, polygon)) << round;
            inside += lasso.contains(place) ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 2000U);
}

TEST(ScreenSelection, LassoChoosesAcrossObjects)
{
    const Scene scene = sceneOf({symmetricSheet(9, 7), symmetricSheet(5, 6)});
    const auto nets = projected(scene, {kFirst, kSecond},
                                [](const Vec3& place) { return std::optional(Vec2(place.x, place.y)); });
    const std::vector<Vec2> triangle{{-2.5, -1}, {3.25, 0.1}, {-0.5, 7}};
    const PointSelection chosen = insideLasso(nets, Lasso(triangle));
    size_t expected = 0;
    for (const ProjectedNet& net : nets)
        for (size_t k = 0; k < net.pixels.size(); ++k) {
            expected += isInside(*net.pixels[k], triangle) ? 1 : 0;
            EXPECT_EQ(chosen.contains({net.object, net.net.indexAt(k)}), isInside(*net.pixels[k], triangle));
        }
    EXPECT_EQ(chosen.size(), expected);
    EXPECT_EQ(chosen.objects().size(), 2U);
}

}  // namespace knotspan::testing
