// Loops cut off at lines of u and v enclose there what they enclosed before, and are sound: closed, the right
// way round, within the part's own domain.
#include <random>

#include <gtest/gtest.h>

#include "model/geometry/knot_insertion.h"
#include "model/trimming/loop_clipping.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

struct Part {
    NurbsSurface surface;
    std::optional<std::vector<TrimLoop>> loops;
};

Part partOf(const std::vector<TrimLoop>& loops, const NurbsSurface& surface, int axis, double low,
            double high)
{
    const Direction direction = axis == 0 ? Direction::U : Direction::V;
    NurbsSurface cut = surface;
    for (const double at : {low, high}) {
        const KnotVector& knots = axis == 0 ? cut.knotsU() : cut.knotsV();
        const auto there = std::count(knots.values().begin(), knots.values().end(), at);
        if (at > knots.domainStart() && at < knots.domainEnd())
            cut = withKnotInserted(cut, direction, at, knots.degree() - static_cast<int>(there));
    }
    auto clippedLoops = loopsBetween(loops, surface, axis, low, high);
    EXPECT_TRUE(clippedLoops);
    return {clampedPart(cut, direction, low, high), clippedLoops.value()};
}

struct Answers {
    int asked = 0;
    int inside = 0;
    int wrong = 0;
};

// In random points of the part, where the whole surface says the same nearby, too.
Answers compared(const std::vector<TrimLoop>& loops, const NurbsSurface& surface, const Part& part)
{
    const TrimRegion before(loops, surface);
    const TrimRegion after(part.loops.value_or(std::vector<TrimLoop>()), part.surface);
    std::mt19937 random(3);
    const auto between = [&](const KnotVector& knots) {
        return std::uniform_real_distribution<double>(knots.domainStart(), knots.domainEnd())(random);
    };
    Answers answers;
    for (int k = 0; k < 3000; ++k) {
        const Vec2 at(between(part.surface.knotsU()), between(part.surface.knotsV()));
        const bool wanted = before.contains(at.x, at.y);
        bool isClear = true;
        for (const Vec2& by : {Vec2(1e-6, 0), Vec2(-1e-6, 0), Vec2(0, 1e-6), Vec2(0, -1e-6)})
            isClear = isClear && before.contains(at.x + by.x, at.y + by.y) == wanted;
        if (!isClear)
            continue;
        ++answers.asked;
        answers.inside += wanted;
        answers.wrong += (part.loops.has_value() && after.contains(at.x, at.y)) != wanted;
    }
    return answers;
}

// Of both parts, cut anywhere; returns how many random points lay inside.
int expectSameAround(const std::vector<TrimLoop>& loops, const NurbsSurface& surface, int axis, double at,
                     const std::string& what)
{
    const KnotVector& knots = axis == 0 ? surface.knotsU() : surface.knotsV();
    int inside = 0;
    for (const auto& [low, high] : {std::pair(knots.domainStart(), at), {at, knots.domainEnd()}}) {
        const Part part = partOf(loops, surface, axis, low, high);
        const Answers answers = compared(loops, surface, part);
        EXPECT_GT(answers.asked, 2900) << what;
        EXPECT_EQ(answers.wrong, 0) << what << ", cut at " << at << " across axis " << axis;
        inside += answers.inside;
        if (part.loops) {
            const TrimRegion region(*part.loops, part.surface);
            EXPECT_TRUE(region.report().empty()) << what << ": " << region.report().front();
            EXPECT_EQ(part.loops->empty(), !region.isTrimmed());
        }
    }
    return inside;
}

const std::vector<TrimLoop> kBorderWithHoles{
    {true, {polyline({{-1, 10}, {3, 10}, {3, 12}, {-1, 12}, {-1, 10}})}},
    {false, {circle({0.5, 11}, 0.5, false)}},
    {false, {circle({2.2, 11.2}, 0.4, false)}},
};

TEST(LoopClippingTest, AnOuterLoopOnTheBorderAndHolesAreCutAnywhere)
{
    for (const double at : {-0.9, 0.0, 0.3, 0.5, 0.99, 1.0, 1.5, 2.2, 2.99})
        EXPECT_GT(expectSameAround(kBorderWithHoles, flatSurface(), 0, at, "holes"), 3000);
    for (const double at : {10.1, 10.5, 11.0, 11.2, 11.75, 11.9})
        EXPECT_GT(expectSameAround(kBorderWithHoles, flatSurface(), 1, at, "holes"), 3000);
}

TEST(LoopClippingTest, HolesAloneKeepWhatIsAroundThem)
{
    const std::vector<TrimLoop> holes{{false, {circle({0.5, 11}, 0.5, false)}},
                                      {false, {circle({2.2, 11.2}, 0.4, false)}}};
    for (const double at : {-0.5, 0.0, 0.6, 1.5, 2.3})
        EXPECT_GT(expectSameAround(holes, flatSurface(), 0, at, "holes alone"), 3000);
    for (const double at : {10.2, 11.0, 11.3, 11.9})
        EXPECT_GT(expectSameAround(holes, flatSurface(), 1, at, "holes alone"), 3000);
}

TEST(LoopClippingTest, LoopsThatTouchTheCutOrCrossThemselvesAreCut)
{
    const std::vector<TrimLoop> eight{
        {true, {polyline({{0, 10.5}, {2, 11.5}, {2, 10.5}, {0, 11.5}, {0, 10.5}})}}};
    const std::vector<TrimLoop> comb{{true,
                                      {polyline({{-0.5, 10.2},
                                                 {2.5, 10.2},
                                                 {2.5, 11.8},
                                                 {2, 10.6},
                                                 {1.5, 11.8},
                                                 {1, 10.6},
                                                 {0.5, 11.8},
                                                 {0, 10.6},
                                                 {-0.5, 11.8},
                                                 {-0.5, 10.2}})}}};
    for (const double at : {0.25, 1.0, 1.75}) {
        const TrimRegion region(eight, flatSurface());
        const Part part = partOf(eight, flatSurface(), 0, -1, at);
        EXPECT_EQ(compared(eight, flatSurface(), part).wrong, 0);
    }
    for (const double at : {0.0, 0.5, 0.75, 1.0, 2.0})
        EXPECT_GT(expectSameAround(comb, flatSurface(), 0, at, "comb"), 1000);
    for (const double at : {10.2, 10.6, 11.0, 11.75})
        EXPECT_GT(expectSameAround(comb, flatSurface(), 1, at, "comb"), 1000);
}

TEST(LoopClippingTest, LoopsAroundAClosedSurfaceAndAcrossItsSeamAreCut)
{
    const double end = roundSurface().knotsU().domainEnd();
    const std::vector<TrimLoop> band{{true, {polyline({{0, 0.2}, {end / 2, 0.4}, {end, 0.2}})}},
                                     {true, {polyline({{end, 0.8}, {end / 2, 0.7}, {0, 0.8}})}}};
    const std::vector<TrimLoop> below{{true, {polyline({{end, 0.6}, {0, 0.6}})}}};
    const std::vector<TrimLoop> seam{{true, {circle({end, 0.5}, 0.3 * end)}}};
    const std::vector<TrimLoop> hole{{false, {circle({end, 0.5}, 0.1 * end, false)}}};
    for (const double at : {0.05, 0.3, 0.5, 0.8, 0.95}) {
        EXPECT_GT(expectSameAround(band, roundSurface(), 0, at * end, "band"), 1000);
        EXPECT_GT(expectSameAround(below, roundSurface(), 0, at * end, "below"), 1000);
        EXPECT_GT(expectSameAround(hole, roundSurface(), 0, at * end, "hole on the seam"), 1000);
        EXPECT_GT(expectSameAround(hole, roundSurface(), 1, at, "hole on the seam"), 1000);
        EXPECT_GT(expectSameAround(band, roundSurface(), 1, at, "band"), at == 0.05 ? 100 : 300);
    }
    for (const double at : {0.1, 0.5, 0.9})
        EXPECT_GT(expectSameAround(seam, roundSurface(), 0, at * end, "loop on the seam"), 1000);
}

TEST(LoopClippingTest, WhatTheCutLeavesAloneStaysToTheBit)
{
    const Part part = partOf(kBorderWithHoles, flatSurface(), 0, 1.2, 3);
    ASSERT_EQ(part.loops->size(), 2U);
    EXPECT_EQ((*part.loops)[0], kBorderWithHoles[2]);
    EXPECT_EQ(partOf(kBorderWithHoles, flatSurface(), 0, -1, 3).loops, kBorderWithHoles);
    const std::vector<TrimLoop> hole{kBorderWithHoles[1]};
    EXPECT_EQ(partOf(hole, flatSurface(), 0, -1, 2).loops, hole);
    EXPECT_EQ(partOf(hole, flatSurface(), 0, 2, 3).loops, std::vector<TrimLoop>());
}

TEST(LoopClippingTest, ThePartOfACircleIsOfItsDegreeAndExact)
{
    const std::vector<TrimLoop> disc{{true, {circle({0.5, 11}, 0.5)}}};
    const Part part = partOf(disc, flatSurface(), 0, 0.75, 3);
    ASSERT_EQ(part.loops->size(), 1U);
    // It begins and ends in the part.
    ASSERT_EQ(part.loops->front().curves.size(), 3U);
    int lines = 0;
    for (const TrimCurve& curve : part.loops->front().curves) {
        lines += curve.knots().degree() == 1;
        for (int k = 0; k <= 20 && curve.knots().degree() == 2; ++k) {
            const double t = curve.knots().domainStart() +
                             (curve.knots().domainEnd() - curve.knots().domainStart()) * k / 20;
            EXPECT_NEAR(glm::length(curve.evaluate(t) - Vec2(0.5, 11)), 0.5, 1e-14);
        }
    }
    EXPECT_EQ(lines, 1);
}

TEST(LoopClippingTest, NothingIsLeftBesideTheLoops)
{
    const std::vector<TrimLoop> disc{{true, {circle({0.5, 11}, 0.5)}}};
    EXPECT_FALSE(partOf(disc, flatSurface(), 0, 1.2, 3).loops.has_value());
    EXPECT_FALSE(partOf(disc, flatSurface(), 1, 10, 10.4).loops.has_value());
    const std::vector<TrimLoop> open{{true, {polyline({{0, 10.5}, {1, 10.5}, {1, 11.5}})}}};
    const auto refused = loopsBetween(open, flatSurface(), 0, -1, 0.5);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find("open"), std::string::npos) << refused.error().sentence();
}

}  // namespace
}  // namespace knotspan::testing
