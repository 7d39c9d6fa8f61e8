// A surface trimmed once more keeps what both the old loops and the curve leave, whatever they cross.
#include <functional>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/trimming/loop_combining.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

const TrimLoop kBorder{true, {polyline({{-1, 10}, {3, 10}, {3, 12}, {-1, 12}, {-1, 10}})}};
const TrimLoop kHole{false, {circle({2.2, 11.2}, 0.4, false)}};
const TrimLoop kOther{false, {circle({0, 11}, 0.5, false)}};

using Inside = std::function<bool(const Vec2&)>;

Inside disc(const Vec2& centre, double radius)
{
    return [=](const Vec2& at) { return glm::length(at - centre) < radius; };
}

// What is left is what `wanted` says in random points, and the loops are sound: closed, the right way round.
void expectLeft(const Result<std::vector<TrimLoop>>& loops, const NurbsSurface& surface, const Inside& wanted,
                const std::string& what)
{
    ASSERT_TRUE(loops) << what << ": " << loops.error().sentence();
    const TrimRegion region(*loops, surface);
    ASSERT_TRUE(region.isTrimmed()) << what;
    for (const std::string& sentence : region.report())
        ADD_FAILURE() << what << ": " << sentence;
    std::mt19937 random(3);
    const auto between = [&](const KnotVector& knots) {
        return std::uniform_real_distribution<double>(knots.domainStart(), knots.domainEnd())(random);
    };
    int wrong = 0;
    int inside = 0;
    for (int k = 0; k < 4000; ++k) {
        const Vec2 at(between(surface.knotsU()), between(surface.knotsV()));
        bool isClear = true;
        for (const Vec2& by : {Vec2(1e-7, 0), Vec2(-1e-7, 0), Vec2(0, 1e-7), Vec2(0, -1e-7)})
            isClear = isClear && wanted(at + by) == wanted(at);
        wrong += isClear && region.contains(at.x, at.y) != wanted(at);
        inside += wanted(at);
    }
    EXPECT_EQ(wrong, 0) << what;
    EXPECT_GT(inside, 20) << what;
    EXPECT_LT(inside, 3980) << what;
}

TEST(LoopCombiningTest, AWholeSurfaceGetsAHoleOrIsCutOut)
{
    const std::vector<TrimCurve> curve{circle({0.5, 11}, 0.6)};
    const Inside in = disc({0.5, 11}, 0.6);
    const auto hole = trimmedBy(curve, {}, flatSurface(), KeptSide::outside);
    expectLeft(
        hole, flatSurface(), [&](const Vec2& at) { return !in(at); }, "hole");
    ASSERT_EQ(hole->size(), 1U);
    EXPECT_FALSE(hole->front().outer);
    expectLeft(trimmedBy(curve, {}, flatSurface(), KeptSide::inside), flatSurface(), in, "disc");
    // However the hand went round.
    expectLeft(trimmedBy({circle({0.5, 11}, 0.6, false)}, {}, flatSurface(), KeptSide::inside), flatSurface(),
               in, "disc drawn the other way round");
}

TEST(LoopCombiningTest, LoopsThatTheCurveDoesNotTouchStayToTheBitOrGo)
{
    const std::vector<TrimLoop> loops{kBorder, kHole, kOther};
    const auto hole = trimmedBy({circle({1.2, 11}, 0.3)}, loops, flatSurface(), KeptSide::outside);
    ASSERT_TRUE(hole);
    ASSERT_EQ(hole->size(), 4U);
    for (size_t k = 0; k < 3; ++k)
        EXPECT_EQ((*hole)[k], loops[k]);
    const auto around = trimmedBy({circle({2.2, 11.2}, 0.6)}, loops, flatSurface(), KeptSide::inside);
    expectLeft(
        around, flatSurface(),
        [](const Vec2& at) {
            return disc({2.2, 11.2}, 0.6)(at) && !disc({2.2, 11.2}, 0.4)(at);
        },
        "ring");
    ASSERT_EQ(around->size(), 2U);
    EXPECT_EQ((*around)[1], kHole);  // outer ones first
    EXPECT_FALSE(trimmedBy({circle({2.2, 11.2}, 0.6)}, loops, flatSurface(), KeptSide::outside)->size() == 4);
}

TEST(LoopCombiningTest, CurvesThatCrossLoopsAreJoinedWithThem)
{
    for (const bool hasBorder : {true, false}) {
        std::vector<TrimLoop> loops{kHole, kOther};
        if (hasBorder)
            loops.push_back(kBorder);
        const Inside left = [](const Vec2& at) {
            return !disc({2.2, 11.2}, 0.4)(at) && !disc({0, 11}, 0.5)(at);
        };
        for (const auto& [centre, radius] : {std::pair(Vec2(0.6, 11.1), 0.5),
                                             {Vec2(1.1, 11.05), 0.85},
                                             {Vec2(2.9, 11.6), 0.7},
                                             {Vec2(0, 10), 0.8},
                                             {Vec2(1, 11), 1.3}}) {
            const Inside in = disc(centre, radius);
            const std::string what = "at " + std::to_string(centre.x) + (hasBorder ? " with border" : "");
            expectLeft(
                trimmedBy({circle(centre, radius)}, loops, flatSurface(), KeptSide::inside), flatSurface(),
                [&](const Vec2& at) { return left(at) && in(at); }, what + " inside");
            expectLeft(
                trimmedBy({circle(centre, radius)}, loops, flatSurface(), KeptSide::outside), flatSurface(),
                [&](const Vec2& at) { return left(at) && !in(at); }, what + " outside");
        }
    }
}

// Many discs, one after the other, as someone goes on trimming.
TEST(LoopCombiningTest, OneTrimAfterTheOther)
{
    std::mt19937 random(17);
    std::uniform_real_distribution<double> share(0, 1);
    int done = 0;
    for (int round = 0; round < 10; ++round) {
        std::vector<TrimLoop> loops;
        Inside left = [](const Vec2&) { return true; };
        for (int k = 0; k < 6; ++k) {
            const Vec2 centre(-1 + 4 * share(random), 10 + 2 * share(random));
            const double radius = 0.1 + 0.4 * share(random);
            auto next = trimmedBy({circle(centre, radius)}, loops, flatSurface(), KeptSide::outside);
            if (!next) {
                EXPECT_NE(next.error().sentence().find("leaves all"), std::string::npos)
                    << next.error().sentence();
                continue;
            }
            loops = *next;
            left = [left, in = disc(centre, radius)](const Vec2& at) { return left(at) && !in(at); };
            ++done;
        }
        expectLeft(loops, flatSurface(), left, "round " + std::to_string(round));
    }
    EXPECT_GT(done, 50);
}

TEST(LoopCombiningTest, CurvesCrossASeam)
{
    const double end = roundSurface().knotsU().domainEnd();
    const auto in = [&](const Vec2& at) {
        const double u = at.x > end / 2 ? at.x - end : at.x;
        return glm::length(Vec2(u, at.y - 0.5)) < 0.3;
    };
    const std::vector<TrimLoop> band{{true, {polyline({{0, 0.4}, {end, 0.4}})}},
                                     {true, {polyline({{end, 0.9}, {0, 0.9}})}}};
    const auto inBand = [](const Vec2& at) { return at.y > 0.4 && at.y < 0.9; };
    for (const double centre : {0.0, end}) {
        const std::vector<TrimCurve> curve{circle({centre, 0.5}, 0.3)};
        expectLeft(trimmedBy(curve, {}, roundSurface(), KeptSide::inside), roundSurface(), in, "disc");
        expectLeft(
            trimmedBy(curve, {}, roundSurface(), KeptSide::outside), roundSurface(),
            [&](const Vec2& at) { return !in(at); }, "hole");
        expectLeft(
            trimmedBy(curve, band, roundSurface(), KeptSide::outside), roundSurface(),
            [&](const Vec2& at) { return inBand(at) && !in(at); }, "hole in a band");
        expectLeft(
            trimmedBy(curve, band, roundSurface(), KeptSide::inside), roundSurface(),
            [&](const Vec2& at) { return inBand(at) && in(at); }, "part of a band");
    }
}

TEST(LoopCombiningTest, HolesAreFilledWithAllThatLiesInThem)
{
    const TrimLoop island{true, {circle({2.2, 11.2}, 0.2)}};
    EXPECT_EQ(withoutHoles({kHole, kBorder, island, kOther}, flatSurface()), std::vector<TrimLoop>{kBorder});
    EXPECT_TRUE(withoutHoles({kHole, kOther}, flatSurface()).empty());
    EXPECT_TRUE(withoutHoles({}, flatSurface()).empty());
    const double end = roundSurface().knotsU().domainEnd();
    const TrimLoop low{true, {polyline({{0, 0.2}, {end, 0.2}})}};
    const TrimLoop high{true, {polyline({{end, 0.9}, {0, 0.9}})}};
    const TrimLoop hole{false, {circle({end / 2, 0.5}, 0.1, false)}};
    EXPECT_EQ(withoutHoles({low, hole, high}, roundSurface()), (std::vector<TrimLoop>{low, high}));
}

void expectRefused(const std::vector<TrimCurve>& curve, const std::vector<TrimLoop>& loops, KeptSide side,
                   const std::string& why)
{
    const auto found = trimmedBy(curve, loops, flatSurface(), side);
    ASSERT_FALSE(found) << why;
    EXPECT_NE(found.error().sentence().find(why), std::string::npos) << found.error().sentence();
}

TEST(LoopCombiningTest, WhatCannotBeDoneIsRefusedWithAReason)
{
    expectRefused({polyline({{0, 11}, {1, 11}, {1, 11.5}})}, {}, KeptSide::inside, "does not close");
    expectRefused({}, {}, KeptSide::inside, "does not close");
    expectRefused({polyline({{0, 10.4}, {2, 11.5}, {2, 10.5}, {0, 11.7}, {0, 10.4}})}, {}, KeptSide::inside,
                  "crosses itself");
    expectRefused({circle({2.2, 11.2}, 0.2)}, {kBorder, kHole}, KeptSide::inside, "leaves nothing");
    expectRefused({circle({2.2, 11.2}, 0.2)}, {kBorder, kHole}, KeptSide::outside, "leaves all");
    expectRefused({circle({1, 11}, 5)}, {kBorder, kHole}, KeptSide::outside, "leaves nothing");
    expectRefused({polyline({{-1, 10}, {1, 10}, {1, 11.5}, {-1, 11.5}, {-1, 10}})}, {kBorder},
                  KeptSide::inside, "runs along");
    expectRefused({circle({1, 11}, 0.3)}, {{true, {polyline({{0, 10.5}, {1, 10.5}, {1, 11.5}})}}},
                  KeptSide::inside, "cannot be followed");
}

}  // namespace
}  // namespace knotspan::testing
