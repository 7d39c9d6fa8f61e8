// Trimmed regions against polygons of the loops' own points, and the index in float against the reference in
// double.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/trimming/loop_crossings.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {
namespace {

TEST(TrimRegion, OfASurfaceWithoutLoopsIsAll)
{
    const TrimRegion region({}, flatSurface());
    EXPECT_FALSE(region.isTrimmed());
    EXPECT_TRUE(region.contains(0, 11));
    const TrimIndex index = TrimIndex::create(region).value();
    for (std::uint32_t k = 0; k < index.ksquadCount(); ++k)
        EXPECT_EQ(index.classOf(k), KsQuadTrim::inside);
}

TEST(TrimRegion, OfACircleIsExactToTheLastDigits)
{
    const Vec2 centre(0.9, 11.1);
    const TrimRegion region({{true, {circle(centre, 0.7)}}}, flatSurface());
    for (int k = 0; k < 3000; ++k) {
        const Vec2 way(std::cos(k * 0.7), std::sin(k * 0.7));
        const Vec2 in = centre + 0.7 * (1 - 1e-12) * way;
        const Vec2 out = centre + 0.7 * (1 + 1e-12) * way;
        EXPECT_TRUE(region.contains(in.x, in.y)) << k;
        EXPECT_FALSE(region.contains(out.x, out.y)) << k;
    }
}

TEST(TrimRegion, OfARingHasAHole)
{
    const std::vector<TrimLoop> loops{{true, {circle({0.9, 11.1}, 0.8)}},
                                      {false, {circle({1, 11.2}, 0.3, false)}}};
    const Counts counts = compare(loops, flatSurface(), 1e-4);
    expectRight(counts, "ring");
    expectRight(compare(loops, flatSurface({-1, 3}, {10, 12}), 1e-4), "ring in one KSQuad");
    EXPECT_GT(counts.inside, 300);
    EXPECT_TRUE(TrimRegion(loops, flatSurface()).report().empty());
}

TEST(TrimRegion, OfAHoleAloneIsTheRest)
{
    const std::vector<TrimLoop> loops{{false, {circle({1, 11.2}, 0.5, false)}}};
    expectRight(compare(loops, flatSurface(), 1e-4, 3000, 200, true), "hole");
    EXPECT_TRUE(TrimRegion(loops, flatSurface()).contains(-1, 10));
    EXPECT_TRUE(TrimRegion(loops, flatSurface()).contains(3, 12));
}

TEST(TrimRegion, OfRandomLoopsOfAllDegreesAgreesWithPolygons)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    for (int round = 0; round < 60; ++round) {
        const int degree = 1 + round % 9;
        const int spans = 2 + round % 7;
        std::vector<TrimPoint> points;
        for (int k = 0; k < degree + spans; ++k)
            points.push_back({{-1.2 + 4.4 * share(random), 9.8 + 2.4 * share(random)},
                              round % 3 == 0 ? 1 : std::exp(3 * share(random))});
        points.back().position = points.front().position;
        const std::vector<TrimLoop> loops{
            {true, {TrimCurve::create(KnotVector::clampedUniform(degree, spans), points).value()}}};
        expectRight(compare(loops, flatSurface(), 2e-4, 1000, 600), "round " + std::to_string(round));
    }
}

TEST(TrimRegion, LoopsAlongKnotLinesAreExact)
{
    const std::vector<TrimLoop> loops{
        {true, {polyline({{-0.25, 10}, {1.5, 10}, {1.5, 11.75}, {-0.25, 11.75}, {-0.25, 10}})}}};
    const TrimRegion region(loops, flatSurface());
    const TrimIndex index = TrimIndex::create(region).value();
    const bool wanted[4] = {false, true, true, false};
    for (std::uint32_t a = 0; a < 4; ++a)
        for (std::uint32_t b = 0; b < 3; ++b)
            EXPECT_EQ(index.classOf(3 * a + b), wanted[a] && b < 2 ? KsQuadTrim::inside : KsQuadTrim::outside)
                << a << " " << b;
    expectRight(compare(loops, flatSurface(), 1e-6), "knot lines");
}

TEST(TrimRegion, LoopsWithLevelSidesAreExact)
{
    for (const double bottom : {10.3, 10.5, 10.9}) {
        const std::vector<TrimLoop> loops{
            {true, {polyline({{-1, 10}, {3, 10}, {3, 12}, {-1, 12}, {-1, 10}})}},
            {false,
             {polyline(
                 {{0, bottom}, {0, 11.3}, {2, 11.3}, {2, 11.2}, {2.5, 11.2}, {2.5, bottom}, {0, bottom}})}}};
        expectRight(compare(loops, flatSurface(), 1e-6), "levels");
        expectRight(compare(loops, flatSurface({-1, 3}, {10, 12}), 1e-6), "levels in one KSQuad");
    }
}

TEST(TrimRegion, TheWholeDomainsBorderTrimsNothing)
{
    const std::vector<TrimLoop> loops{{true, {polyline({{-1, 10}, {3, 10}, {3, 12}, {-1, 12}, {-1, 10}})}}};
    const TrimIndex index = TrimIndex::create(TrimRegion(loops, flatSurface())).value();
    for (std::uint32_t k = 0; k < index.ksquadCount(); ++k)
        EXPECT_EQ(index.classOf(k), KsQuadTrim::inside) << k;
    EXPECT_TRUE(TrimRegion(loops, flatSurface()).contains(3, 12));
}

TEST(TrimRegion, OfTenThousandPiecesIsFoundByLookingAtFew)
{
    std::vector<Vec2> places;
    constexpr int kPieces = 10000;
    for (int k = 0; k <= kPieces; ++k) {
        const double angle = 2 * 3.14159265358979 * (k % kPieces) / kPieces;
        const double radius = 0.8 + 0.05 * std::sin(40 * angle) + 0.001 * (k % 2);
        places.emplace_back(0.7 + 1.5 * radius * std::cos(angle), 11 + radius * std::sin(angle));
    }
    const std::vector<TrimLoop> loops{{true, {polyline(places)}}};
    expectRight(compare(loops, flatSurface(), 1e-7, 1000, 1), "10000");
    const TrimIndex index = TrimIndex::create(TrimRegion(loops, flatSurface())).value();
    EXPECT_LT(index.mostPieces(), 100U);
    EXPECT_LT(index.words().size(), 1000000U);
}

// Slanted teeth that reach across KSQuads, so that each height of the border between them is crossed by many.
std::vector<TrimLoop> comb(int teeth)
{
    std::vector<Vec2> places;
    for (int k = 0; k < teeth; ++k) {
        const double v = 10.1 + 1.0 * k / teeth;
        places.emplace_back(-0.9, v);
        places.emplace_back(2.9, v + 0.8 + 0.4 / teeth);
    }
    places.emplace_back(2.9, 10.05);
    places.emplace_back(-0.9, 10.05);
    places.push_back(places.front());
    return {{true, {polyline(places)}}};
}

TEST(TrimRegion, ACombOfSlantedTeethIsRight)
{
    expectRight(compare(comb(150), flatSurface(), 1e-6, 1000, 1), "comb");
}

TEST(TrimRegion, WhatIsTooIntricateToBeIndexedIsRefusedSoon)
{
    const auto index = TrimIndex::create(TrimRegion(comb(5000), flatSurface()));
    ASSERT_FALSE(index.has_value());
    EXPECT_NE(index.error().what.find("too intricate"), std::string::npos);
}

TEST(TrimRegion, LoopsThatTouchAndSliversAreRight)
{
    const std::vector<TrimLoop> touching{{true, {circle({0.5, 11}, 0.5)}},
                                         {true, {circle({1.5, 11}, 0.5)}},
                                         {false, {circle({0.25, 11}, 0.25, false)}}};
    expectRight(compare(touching, flatSurface(), 1e-4), "touching");
    const double thin = 1e-7;
    const std::vector<TrimLoop> sliver{
        {true,
         {polyline({{-0.5, 10.5}, {2.5, 11.5}, {2.5, 11.5 + thin}, {-0.5, 10.5 + thin}, {-0.5, 10.5}})}}};
    const TrimRegion region(sliver, flatSurface());
    for (int k = 1; k < 100; ++k) {
        const double u = -0.5 + 3.0 * k / 100;
        const double v = 10.5 + 1.0 * k / 100;
        EXPECT_TRUE(region.contains(u, v + thin / 2));
        EXPECT_FALSE(region.contains(u, v - thin / 2));
        EXPECT_FALSE(region.contains(u, v + 2 * thin));
    }
    expectRight(compare(sliver, flatSurface(), 1e-5), "sliver");
}

TEST(TrimRegion, ALoopThatCrossesItselfEnclosesBothLobes)
{
    const std::vector<TrimLoop> loops{
        {true, {polyline({{0, 10.5}, {2, 11.4}, {2, 10.5}, {0, 11.5}, {0, 10.5}})}}};
    const Counts counts = compare(loops, flatSurface(), 1e-6);
    expectRight(counts, "eight");
    EXPECT_GT(counts.inside, 100);
    EXPECT_EQ(TrimRegion(loops, flatSurface()).report(), std::vector<std::string>()) << "it encloses something";
    EXPECT_EQ(crossingsOf(TrimRegion(loops, flatSurface())),
              std::vector<std::string>{"Trim loop 1 crosses itself."});
}

TEST(TrimRegion, LoopsThatCrossAreNamedAndThoseThatTouchAreNot)
{
    const auto crossings = [](const std::vector<TrimLoop>& loops) {
        return crossingsOf(TrimRegion(loops, flatSurface()));
    };
    const TrimLoop left{true, {circle({0.5, 11}, 0.5)}};
    EXPECT_TRUE(crossings({left, {true, {circle({1.5, 11}, 0.5)}}}).empty());
    EXPECT_TRUE(crossings({left, {false, {circle({0.25, 11}, 0.25, false)}}}).empty());
    EXPECT_TRUE(crossings({left, {true, {circle({0.5, 11}, 0.5, false)}}}).empty()) << "along each other";
    const std::vector<std::string> both{"Trim loops 1 and 2 cross each other."};
    EXPECT_EQ(crossings({left, {true, {circle({1.2, 11}, 0.5)}}}), both);
    EXPECT_EQ(crossings({left, {true, {polyline({{0.5, 10.9}, {2, 10.9}, {2, 11.1}, {0.5, 10.9}})}}}), both);
}

// The index rounds to floats of the KSQuad: what it says wrongly is this near to a curve.
TEST(TrimIndex, InFloatAnswersAreRightButForAFewMillionthsOfAKsQuad)
{
    constexpr double kNear = 2e-6;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    int asked = 0;
    int wrong = 0;
    for (int round = 0; round < 40; ++round) {
        const int degree = 1 + round % 7;
        std::vector<TrimPoint> points;
        for (int k = 0; k < degree + 3; ++k)
            points.push_back(
                {{4 * share(random), 3 * share(random)}, round % 2 == 0 ? 1 : 0.3 + share(random)});
        points.back().position = points.front().position;
        const TrimCurve curve = TrimCurve::create(KnotVector::clampedUniform(degree, 3), points).value();
        const TrimRegion region({{true, {curve}}}, flatSurface({0, 1, 2, 3, 4}, {0, 1, 2, 3}));
        const TrimIndex index = TrimIndex::create(region).value();
        for (int k = 0; k < 2000; ++k) {
            const double t = share(random);
            const Vec2 way = curve.derivative(t);
            const Vec2 off = Vec2(-way.y, way.x) / glm::length(way) * (k % 2 == 0 ? kNear : -kNear);
            const TrimRegion::Place place =
                region.placeOf((curve.evaluate(t) + off).x, (curve.evaluate(t) + off).y);
            const auto x = static_cast<float>(place.t.x);
            const auto y = static_cast<float>(place.t.y);
            // Asked of the very point that is a float.
            const double u = place.a + static_cast<double>(x);
            const double v = place.b + static_cast<double>(y);
            // Another part of the curve may be nearer: then no side is right.
            bool alone = true;
            for (const Vec2 step : {Vec2(kNear, 0), Vec2(-kNear, 0), Vec2(0, kNear), Vec2(0, -kNear)})
                alone = alone && region.contains(u + 0.5 * step.x, v + 0.5 * step.y) == region.contains(u, v);
            if (!alone)
                continue;
            ++asked;
            wrong += index.contains(static_cast<std::uint32_t>(place.a * 3 + place.b), x, y) !=
                     region.contains(u, v);
        }
    }
    EXPECT_GT(asked, 60000);
    EXPECT_EQ(wrong, 0);
}

TEST(TrimRegion, WhatReachesBeyondTheSurfaceIsCutOffThereAndSaid)
{
    const std::vector<TrimLoop> loops{{true, {circle({-0.9, 11}, 0.7)}}};
    expectRight(compare(loops, flatSurface(), 1e-4), "beyond");
    const TrimRegion region(loops, flatSurface());
    ASSERT_EQ(region.report().size(), 1U);
    EXPECT_NE(region.report()[0].find("reaches beyond the surface by 15 %"), std::string::npos)
        << region.report()[0];
    for (const auto& chain : region.chains())
        for (size_t k = 0; k < chain.size(); ++k)
            EXPECT_GE(chain[k].points.front().position.x, 0);
}

// A circle of three arcs: its control points stand at twice the radius.
TEST(TrimRegion, ControlPointsBeyondTheSurfaceAreNotSpokenOf)
{
    std::vector<TrimPoint> points;
    for (int k = 0; k <= 6; ++k) {
        const double angle = (k % 6) * std::acos(-1.0) / 3;
        const double reach = k % 2 == 0 ? 0.9 : 1.8;
        points.push_back(
            {Vec2(1, 11) + reach * Vec2(std::cos(angle), std::sin(angle)), k % 2 == 0 ? 1.0 : 0.5});
    }
    const std::vector<TrimLoop> loops{
        {true,
         {TrimCurve::create(KnotVector::create(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 3}).value(), points).value()}}};
    const TrimRegion region(loops, flatSurface());
    EXPECT_TRUE(region.isTrimmed());
    EXPECT_EQ(region.report(), std::vector<std::string>());
    expectRight(compare(loops, flatSurface(), 1e-4), "three arcs");
}

TEST(TrimRegion, AnOpenLoopIsRefusedAndSaid)
{
    const TrimRegion region({{true, {polyline({{0, 10.5}, {2, 10.5}, {2, 11.5}})}}}, flatSurface());
    EXPECT_FALSE(region.isTrimmed());
    EXPECT_TRUE(region.contains(-1, 10));
    ASSERT_EQ(region.report().size(), 1U);
    EXPECT_NE(region.report()[0].find("is open by"), std::string::npos) << region.report()[0];
}

TEST(TrimRegion, WhatHadTheLoopsRefusedIsSaidFirst)
{
    const TrimRegion region({{true, {circle({-0.9, 11}, 0.7)}}, {true, {polyline({{0, 10.5}, {2, 10.5}})}}},
                            flatSurface());
    ASSERT_EQ(region.report().size(), 2U);
    EXPECT_NE(region.report()[0].find("Trim loop 2 is open by"), std::string::npos) << region.report()[0];
    EXPECT_NE(region.report()[1].find("reaches beyond"), std::string::npos) << region.report()[1];
}

TEST(TrimRegion, ASmallGapIsClosedByALineAndSaid)
{
    const std::vector<TrimLoop> loops{
        {true, {polyline({{0, 10.5}, {2, 10.5}}), polyline({{2.004, 10.5}, {1, 11.5}, {0.001, 10.5}})}}};
    const TrimRegion region(loops, flatSurface());
    EXPECT_TRUE(region.isTrimmed());
    EXPECT_TRUE(region.contains(1, 11));
    EXPECT_FALSE(region.contains(2.5, 11));
    ASSERT_EQ(region.report().size(), 1U);
    EXPECT_NE(region.report()[0].find("closed by lines"), std::string::npos) << region.report()[0];
}

TEST(TrimRegion, ALoopAcrossTheSeamGoesOnAtItsOtherSide)
{
    const TrimRegion region({{true, {circle({1, 0.5}, 0.2)}}}, roundSurface());
    EXPECT_TRUE(region.contains(0.9, 0.5));
    EXPECT_TRUE(region.contains(0.1, 0.5));
    EXPECT_FALSE(region.contains(0.3, 0.5));
    EXPECT_FALSE(region.contains(0.7, 0.5));
    EXPECT_FALSE(region.contains(0.1, 0.8));
}

TEST(TrimRegion, TwoLoopsAroundACylinderKeepWhatLiesBetween)
{
    const TrimLoop lower{true, {polyline({{0, 0.2}, {0.5, 0.3}, {1, 0.2}})}};
    const TrimLoop upper{true, {polyline({{1, 0.8}, {0, 0.8}})}};
    const TrimRegion between({lower, upper}, roundSurface());
    EXPECT_FALSE(between.contains(0.5, 0.25));
    EXPECT_TRUE(between.contains(0.5, 0.5));
    EXPECT_FALSE(between.contains(0.5, 0.9));
    const TrimRegion below({upper}, roundSurface());
    EXPECT_TRUE(below.contains(0.5, 0.1));
    EXPECT_FALSE(below.contains(0.5, 0.9));
    const TrimRegion above({lower}, roundSurface());
    EXPECT_FALSE(above.contains(0.1, 0.1));
    EXPECT_TRUE(above.contains(0.1, 0.9));
}

// The area by pieces, as Green has it.
TEST(TrimRegion, ItsChainsAreClosedAndEncloseTheAreaOfTheLoops)
{
    const std::vector<TrimLoop> loops{{true, {circle({0.9, 11.1}, 0.8)}},
                                      {false, {circle({1, 11.2}, 0.3, false)}}};
    const NurbsSurface surface = flatSurface();
    const std::vector<double> u{-1, -0.25, 0.125, 1.5, 3};
    const std::vector<double> v{10, 11, 11.75, 12};
    double area = 0;
    const TrimRegion region(loops, surface);
    for (const auto& chain : region.chains()) {
        std::vector<Vec2> polygon;
        for (const RegionPiece& piece : chain) {
            const Vec2 low(u[static_cast<size_t>(piece.a)], v[static_cast<size_t>(piece.b)]);
            const Vec2 high(u[static_cast<size_t>(piece.a) + 1], v[static_cast<size_t>(piece.b) + 1]);
            const auto place = [&](double t) { return low + placeOf(piece.points, t) * (high - low); };
            const TrimCurve& curve = loops[piece.loop].curves[piece.curve];
            for (const double t : {0.0, 0.3, 1.0}) {
                const Vec2 wanted = curve.evaluate(piece.from + t * (piece.to - piece.from));
                EXPECT_LT(glm::length(place(t) - wanted), 1e-12);
            }
            if (!polygon.empty()) {
                EXPECT_LT(glm::length(polygon.back() - place(0)), 1e-2);
            }
            for (int k = 0; k < 300; ++k)
                polygon.push_back(place(k / 300.0));
        }
        for (size_t k = 0; k < polygon.size(); ++k) {
            const Vec2 a = polygon[k] - polygon[0];
            const Vec2 b = polygon[(k + 1) % polygon.size()] - polygon[0];
            area += (a.x * b.y - a.y * b.x) / 2;
        }
    }
    EXPECT_NEAR(area, 3.14159265358979 * (0.64 - 0.09), 1e-5);
}

}  // namespace
}  // namespace knotspan::testing
