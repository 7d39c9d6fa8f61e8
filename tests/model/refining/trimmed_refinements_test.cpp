// Trim loops follow their surface through every refinement: the same points in space are left.
#include <random>

#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/making/object_making.h"
#include "model/refining/object_refinement.h"
#include "model/trimming/trim_region.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

// A smooth closed curve around a place of the unit square, into the surface's domain.
TrimLoop ovalIn(const NurbsSurface& surface, const Vec2& centre, const Vec2& radii, bool outer)
{
    const Vec2 low(surface.knotsU().domainStart(), surface.knotsV().domainStart());
    const Vec2 size = Vec2(surface.knotsU().domainEnd(), surface.knotsV().domainEnd()) - low;
    const Vec2 corners[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}};
    std::vector<TrimPoint> points;
    for (int k = 0; k < 9; ++k)
        points.push_back({low + size * (centre + radii * corners[outer ? k : 8 - k]), k % 2 == 0 ? 1 : 0.7});
    return {outer,
            {TrimCurve::create(KnotVector::create(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}).value(), points)
                 .value()}};
}

SceneObject trimmedObject(std::mt19937& random, bool rational)
{
    SceneObject object{.name = "face",
                       .surface = randomSurface(random, {.spans = 4, .rational = rational}),
                       .trimLoops = {}};
    object.trimLoops = {ovalIn(object.surface, {0.5, 0.5}, {0.45, 0.4}, true),
                        ovalIn(object.surface, {0.4, 0.5}, {0.2, 0.15}, false)};
    return object;
}

struct Compared {
    int inside = 0;
    int outside = 0;
};

// Each of the random places lies in the first or in the other of the objects, at the place that `where` says,
// and both know the same point in space and whether it is left.
template <class Where>
Compared expectSamePoints(const SceneObject& before, const std::vector<const SceneObject*>& after,
                          const Where& where, double allowed, const std::string& what)
{
    const TrimRegion region(before.trimLoops, before.surface);
    std::vector<TrimRegion> regions;
    for (const SceneObject* object : after)
        regions.emplace_back(object->trimLoops, object->surface);
    std::mt19937 random(11);
    const auto between = [&](const KnotVector& knots) {
        return randomBetween(random, knots.domainStart(), knots.domainEnd());
    };
    Compared counts;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 at(between(before.surface.knotsU()), between(before.surface.knotsV()));
        const auto [which, there] = where(at);
        const Vec3 wanted = evaluate(before.surface, at.x, at.y).position;
        const Vec3 found = evaluate(after[which]->surface, there.x, there.y).position;
        EXPECT_LE(glm::length(wanted - found), allowed) << what;
        const bool isLeft = region.contains(at.x, at.y);
        EXPECT_EQ(isLeft, regions[which].contains(there.x, there.y))
            << what << " at " << at.x << ", " << at.y;
        (isLeft ? counts.inside : counts.outside) += 1;
    }
    for (const TrimRegion& one : regions)
        EXPECT_TRUE(one.report().empty()) << what << ": " << one.report().front();
    return counts;
}

class TrimmedRefinementsTest : public ::testing::TestWithParam<RefinementKind> {};

TEST_P(TrimmedRefinementsTest, LeavesTheSamePoints)
{
    std::mt19937 random(5);
    for (int round = 0; round < 6; ++round) {
        // Fewer knots may not be able to follow weights.
        const bool fits = GetParam() == RefinementKind::removeKnot ||
                          GetParam() == RefinementKind::lowerDegree || GetParam() == RefinementKind::rebuild;
        const SceneObject object = trimmedObject(random, !fits && round % 2 == 1);
        for (const Direction direction : {Direction::U, Direction::V}) {
            const KnotVector& knots =
                direction == Direction::U ? object.surface.knotsU() : object.surface.knotsV();
            const double share = randomBetween(random, 0.3, 0.7);
            const double parameter = knots.domainStart() + share * (knots.domainEnd() - knots.domainStart());
            const auto found = refined(object, {.kind = GetParam(),
                                                .direction = direction,
                                                .parameter = parameter,
                                                .tolerance = 1e9,
                                                .shape = {9, 8, 3, 3}});
            ASSERT_TRUE(found) << found.error().sentence();
            std::vector<const SceneObject*> after{&found->object};
            if (found->other)
                after.push_back(&*found->other);
            const auto where = [&](const Vec2& at) {
                const int axis = direction == Direction::U ? 0 : 1;
                if (GetParam() == RefinementKind::split)
                    return std::pair(at[axis] < parameter ? size_t{0} : size_t{1}, at);
                if (GetParam() == RefinementKind::swap)
                    return std::pair(size_t{0}, Vec2(at.y, at.x));
                Vec2 there = at;
                if (GetParam() == RefinementKind::reverse)
                    there[axis] = -there[axis];
                return std::pair(size_t{0}, there);
            };
            const Compared counts = expectSamePoints(object, after, where, found->deviation.bound + 1e-9,
                                                     "round " + std::to_string(round));
            EXPECT_GT(counts.inside, 500);
            EXPECT_GT(counts.outside, 500);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TrimmedRefinementsTest,
                         ::testing::Values(RefinementKind::insertKnot, RefinementKind::removeKnot,
                                           RefinementKind::raiseDegree, RefinementKind::lowerDegree,
                                           RefinementKind::rebuild, RefinementKind::split,
                                           RefinementKind::reverse, RefinementKind::swap));

TEST(TrimmedRefinementTest, TurnedTwiceTheLoopsAreWhatTheyWereToTheBit)
{
    std::mt19937 random(9);
    const SceneObject object = trimmedObject(random, true);
    for (const RefinementRequest& request :
         {RefinementRequest{.kind = RefinementKind::reverse, .direction = Direction::U},
          RefinementRequest{.kind = RefinementKind::reverse, .direction = Direction::V},
          RefinementRequest{.kind = RefinementKind::swap}}) {
        const auto once = refined(object, request);
        ASSERT_TRUE(once);
        EXPECT_NE(once->object, object);
        EXPECT_EQ(refined(once->object, request)->object, object);
    }
}

TEST(TrimmedRefinementTest, ACutBesideWhatIsLeftIsRefused)
{
    std::mt19937 random(9);
    SceneObject object = trimmedObject(random, false);
    object.trimLoops = {ovalIn(object.surface, {0.25, 0.5}, {0.2, 0.3}, true)};
    const KnotVector& knots = object.surface.knotsU();
    const double at = knots.domainStart() + 0.8 * (knots.domainEnd() - knots.domainStart());
    const auto found = refined(object, {.kind = RefinementKind::split, .parameter = at});
    ASSERT_FALSE(found);
    EXPECT_NE(found.error().sentence().find("Nothing is left"), std::string::npos);
}

TEST(TrimmedRefinementTest, WhatIsMovedMirroredOrCopiedKeepsItsLoopsToTheBit)
{
    std::mt19937 random(9);
    const SceneObject object = trimmedObject(random, true);
    const auto mirror = mirrored(object, {});
    const auto moved =
        knotspan::moved(object, transformMatrix({.degrees = {10, 20, 30}, .scale = {1, -2, 3}}).value());
    ASSERT_TRUE(mirror && moved);
    for (const SceneObject& other : {*mirror, *moved, duplicated(object, Scene())}) {
        EXPECT_EQ(other.trimLoops, object.trimLoops);
        EXPECT_EQ(other.surface, object.surface);
    }
}

}  // namespace
}  // namespace knotspan::testing
