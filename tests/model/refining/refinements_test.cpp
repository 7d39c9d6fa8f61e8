// Refinements against the surfaces they came from, evaluated at random places by the double reference.
#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "model/refining/refinements.h"
#include "model/samples/net.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

double randomIn(std::mt19937& random, const KnotVector& knots)
{
    return randomBetween(random, knots.domainStart(), knots.domainEnd());
}

double largestBetween(std::mt19937& random, const NurbsSurface& a, const NurbsSurface& b, int places = 300)
{
    double largest = 0;
    for (int k = 0; k < places; ++k) {
        const double u = randomIn(random, a.knotsU());
        const double v = randomIn(random, a.knotsV());
        largest = std::max(largest, glm::distance(evaluate(a, u, v).position, evaluate(b, u, v).position));
    }
    return largest;
}

NurbsSurface anySurface(std::mt19937& random, int round)
{
    RandomSurfaceShape shape;
    shape.degreeU = 1 + round % 5;
    shape.degreeV = 1 + round / 5 % 5;
    shape.spans = 2 + round % 4;
    shape.rational = round % 2 == 1;
    shape.clamped = round % 7 != 3;
    shape.offset = round % 11 == 5 ? 1e5 : 0;
    return randomSurface(random, shape);
}

const KnotVector& along(const NurbsSurface& surface, Direction direction)
{
    return direction == Direction::U ? surface.knotsU() : surface.knotsV();
}

// What rounding of coordinates and of a fit costs.
double rounding(const NurbsSurface& surface)
{
    return 1e-12 * (surface.bounds().diagonal() + glm::length(surface.bounds().centre()));
}

}  // namespace

TEST(Refinements, ThatAddChangeNothing)
{
    std::mt19937 random(31);
    for (int round = 0; round < 100; ++round) {
        const NurbsSurface surface = anySurface(random, round);
        const Direction direction = round % 2 == 0 ? Direction::U : Direction::V;
        const auto finer = insertKnot(surface, direction, randomIn(random, along(surface, direction)));
        const auto higher = raiseDegree(surface, direction);
        ASSERT_TRUE(finer);
        ASSERT_TRUE(higher);
        for (const Refinement* const done : {&*finer, &*higher}) {
            EXPECT_LE(largestBetween(random, surface, done->surface), rounding(surface)) << round;
            EXPECT_LE(done->deviation.bound, rounding(surface)) << round;
        }
        EXPECT_EQ(along(higher->surface, direction).degree(), along(surface, direction).degree() + 1);
    }
}

TEST(Refinements, ThatTakeAwayWhatWasAddedReturnTheSurface)
{
    std::mt19937 random(32);
    for (int round = 0; round < 100; ++round) {
        const NurbsSurface surface = anySurface(random, round);
        const Direction direction = round % 2 == 0 ? Direction::U : Direction::V;
        const double value = randomIn(random, along(surface, direction));
        const auto finer = insertKnot(surface, direction, value);
        const auto back = removeKnot(finer->surface, direction, value, rounding(surface));
        ASSERT_TRUE(back) << round << back.error().sentence();
        EXPECT_LE(largestBetween(random, surface, back->surface), rounding(surface));
        const auto higher = raiseDegree(surface, direction);
        const auto lower = lowerDegree(higher->surface, direction, rounding(surface));
        ASSERT_TRUE(lower) << round << lower.error().sentence();
        EXPECT_LE(largestBetween(random, surface, lower->surface), rounding(surface));
        EXPECT_EQ(along(lower->surface, direction).degree(), along(surface, direction).degree());
    }
}

TEST(Refinements, StayWithinWhatTheyAnnounced)
{
    std::mt19937 random(33);
    size_t moved = 0;
    for (int round = 0; round < 100; ++round) {
        const NurbsSurface surface = anySurface(random, round);
        const Direction direction = round % 2 == 0 ? Direction::U : Direction::V;
        const auto look = [&](const Result<Refinement>& one) {
            if (!one) {
                EXPECT_FALSE(one.error().sentence().empty());
                return;
            }
            const double largest = largestBetween(random, surface, one->surface);
            EXPECT_LE(largest, one->deviation.bound + rounding(surface)) << round;
            EXPECT_LE(one->deviation.measured, one->deviation.bound);
            const double loose = surface.isRational() ? 30 : 3;
            EXPECT_LE(one->deviation.bound, loose * one->deviation.measured + rounding(surface)) << round;
            moved += largest > 1e-3 ? 1 : 0;
        };
        look(removeKnot(surface, direction, randomIn(random, along(surface, direction)), 1e9));
        look(lowerDegree(surface, direction, 1e9));
        look(rebuild(surface, {4 + round % 5, 5 + round % 3, 2 + round % 3, 3}));
    }
    EXPECT_GT(moved, 100U);
}

TEST(Refinements, RefuseWhatIsBeyondTheToleranceAndSayHowFar)
{
    const NurbsSurface ball = sphere(Vec3(0), 1);
    const auto removed = removeKnot(ball, Direction::U, 2, 1e-6);
    ASSERT_FALSE(removed);
    EXPECT_NE(removed.error().sentence().find("The surface would move by up to"), std::string::npos);
    EXPECT_FALSE(lowerDegree(plane(Vec3(0), {1, 0, 0}, {0, 1, 0}), Direction::U, 1));
    EXPECT_FALSE(insertKnot(ball, Direction::U, 0));
    EXPECT_FALSE(insertKnot(ball, Direction::U, 2));  // stands twice already, of degree 2
    EXPECT_FALSE(insertKnot(ball, Direction::V, std::nan("")));
    EXPECT_FALSE(rebuild(ball, {3, 8, 3, 3}));
    EXPECT_FALSE(rebuild(ball, {30, 8, 16, 3}));
    EXPECT_FALSE(splitAt(ball, Direction::V, 4));
}

TEST(Refinements, RebuildComesNearerWithMorePoints)
{
    const KnotVector knots = clampedIntegerKnots(3, 6);
    const NurbsSurface wave = surfaceOf(knots, knots, [&](int i, int j) {
        return ControlPoint{
            {grevilleAbscissa(knots, i), grevilleAbscissa(knots, j), std::sin(i) * std::cos(j)}, 1};
    });
    double before = 1e9;
    for (const int count : {6, 8, 13, 25}) {
        const auto rebuilt = rebuild(wave, {count, count, 3, 3});
        ASSERT_TRUE(rebuilt);
        EXPECT_EQ(rebuilt->surface.countU(), count);
        EXPECT_LT(rebuilt->deviation.bound, before);
        before = rebuilt->deviation.bound;
        for (const int i : {0, 1})
            for (const int j : {0, 1})
                EXPECT_EQ(rebuilt->surface.controlPoint(i * (count - 1), j * (count - 1)).position,
                          wave.controlPoint(i * (wave.countU() - 1), j * (wave.countV() - 1)).position);
    }
    EXPECT_LT(before, 0.01);
}

TEST(Refinements, SplittingKeepsBothPartsAndTheirBorderToTheBit)
{
    std::mt19937 random(34);
    for (int round = 0; round < 50; ++round) {
        const NurbsSurface surface = anySurface(random, round);
        const Direction direction = round % 2 == 0 ? Direction::U : Direction::V;
        const auto parts = splitAt(surface, direction, randomIn(random, along(surface, direction)));
        ASSERT_TRUE(parts);
        const NurbsSurface& a = parts->first;
        const NurbsSurface& b = parts->second;
        EXPECT_LE(largestBetween(random, a, surface, 60), rounding(surface));
        EXPECT_LE(largestBetween(random, b, surface, 60), rounding(surface));
        const bool byU = direction == Direction::U;
        for (int k = 0; k < (byU ? a.countV() : a.countU()); ++k)
            EXPECT_EQ(byU ? a.controlPoint(a.countU() - 1, k) : a.controlPoint(k, a.countV() - 1),
                      byU ? b.controlPoint(0, k) : b.controlPoint(k, 0));
    }
}

}  // namespace knotspan::testing
