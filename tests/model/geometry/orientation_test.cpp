#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/orientation.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

NurbsSurface anySurface(std::mt19937& random, int degree, bool clamped = true)
{
    return testing::randomSurface(random, {.degreeU = degree,
                                           .degreeV = 8 - degree,
                                           .spans = 4,
                                           .rational = degree % 2 == 0,
                                           .clamped = clamped});
}

// `other` at change(u, v) is where `surface` is at (u, v).
template <class Change>
void expectSamePoints(const NurbsSurface& other, const NurbsSurface& surface, const Change& change)
{
    const double size = surface.bounds().diagonal();
    for (int i = 0; i <= 12; ++i)
        for (int j = 0; j <= 12; ++j) {
            const KnotVector& knotsU = surface.knotsU();
            const KnotVector& knotsV = surface.knotsV();
            const Vec2 at{knotsU.domainStart() + (knotsU.domainEnd() - knotsU.domainStart()) * i / 12.0,
                          knotsV.domainStart() + (knotsV.domainEnd() - knotsV.domainStart()) * j / 12.0};
            const Vec2 there = change(at);
            EXPECT_LE(glm::length(evaluate(other, there.x, there.y).position -
                                  evaluate(surface, at.x, at.y).position),
                      1e-12 * size);
        }
}

TEST(Orientation, TurnsADirectionRoundWithoutLosingABit)
{
    std::mt19937 random(81);
    for (int degree = 1; degree <= 7; ++degree)
        for (const bool clamped : {true, false}) {
            const NurbsSurface surface = anySurface(random, degree, clamped);
            const NurbsSurface inU = reversed(surface, Direction::U);
            const NurbsSurface inV = reversed(surface, Direction::V);
            expectSamePoints(inU, surface, [](Vec2 at) { return Vec2(-at.x, at.y); });
            expectSamePoints(inV, surface, [](Vec2 at) { return Vec2(at.x, -at.y); });
            EXPECT_EQ(reversed(inU, Direction::U), surface);
            EXPECT_EQ(reversed(inV, Direction::V), surface);
        }
}

TEST(Orientation, ExchangesUAndVWithoutLosingABit)
{
    std::mt19937 random(82);
    const NurbsSurface surface = anySurface(random, 2);
    const NurbsSurface other = swapped(surface);
    EXPECT_EQ(other.degreeU(), 6);
    EXPECT_EQ(other.controlPoint(4, 1), surface.controlPoint(1, 4));
    expectSamePoints(other, surface, [](Vec2 at) { return Vec2(at.y, at.x); });
    EXPECT_EQ(swapped(other), surface);
}

TEST(Orientation, MapsADomainAndMeetsItsEnds)
{
    std::mt19937 random(83);
    for (int degree = 1; degree <= 7; ++degree) {
        const NurbsSurface surface = anySurface(random, degree, degree != 3);
        const double a = surface.knotsV().domainStart();
        const double b = surface.knotsV().domainEnd();
        const NurbsSurface other = withDomain(surface, Direction::V, 10, 17.3).value();
        EXPECT_EQ(other.knotsV().domainStart(), 10);
        EXPECT_EQ(other.knotsV().domainEnd(), 17.3);
        EXPECT_EQ(other.knotsU(), surface.knotsU());
        expectSamePoints(other, surface,
                         [&](Vec2 at) { return Vec2(at.x, 10 + 7.3 * (at.y - a) / (b - a)); });
    }
}

TEST(Orientation, RefusesADomainWithoutLengthWithASentence)
{
    std::mt19937 random(84);
    const NurbsSurface surface = anySurface(random, 3);
    EXPECT_FALSE(withDomain(surface, Direction::U, 1, 1));
    EXPECT_FALSE(withDomain(surface, Direction::U, 0, std::numeric_limits<double>::infinity()));
    const auto tooShort = withDomain(surface, Direction::U, 1, 1 + 2e-16);
    ASSERT_FALSE(tooShort);
    EXPECT_FALSE(tooShort.error().sentence().empty());
}

// A triangle with a rational quadratic for one side, run counterclockwise.
TrimLoop triangle()
{
    const auto knots = [](int degree) {
        std::vector<double> values(static_cast<size_t>(degree) + 1, 0.25);
        values.resize(values.size() * 2, 2.0);
        return KnotVector::create(degree, values).value();
    };
    TrimLoop loop;
    loop.curves.push_back(TrimCurve::create(knots(1), {{{0, 0}, 1}, {{3, 0.1}, 1}}).value());
    loop.curves.push_back(TrimCurve::create(knots(2), {{{3, 0.1}, 1}, {{3, 2}, 0.4}, {{1, 2.5}, 1}}).value());
    loop.curves.push_back(TrimCurve::create(knots(1), {{{1, 2.5}, 1}, {{0, 0}, 1}}).value());
    return loop;
}

double areaOf(const TrimLoop& loop)
{
    double area = 0;
    for (const TrimCurve& curve : loop.curves)
        for (int k = 0; k < 50; ++k) {
            const KnotVector& knots = curve.knots();
            const auto at = [&](double part) {
                return curve.evaluate(knots.domainStart() + part * (knots.domainEnd() - knots.domainStart()));
            };
            const Vec2 a = at(k / 50.0);
            const Vec2 b = at((k + 1) / 50.0);
            area += (a.x * b.y - b.x * a.y) / 2;
        }
    return area;
}

void expectChained(const TrimLoop& loop)
{
    for (size_t k = 0; k < loop.curves.size(); ++k)
        EXPECT_EQ(loop.curves[k].points().back().position,
                  loop.curves[(k + 1) % loop.curves.size()].points().front().position);
}

TEST(Orientation, KeepsTheFaceLeftOfATrimLoopThatFollows)
{
    const TrimLoop loop = triangle();
    const double area = areaOf(loop);
    ASSERT_GT(area, 1);
    for (const TrimLoop& other :
         {reversed(loop, Direction::U), reversed(loop, Direction::V), swapped(loop)}) {
        EXPECT_NEAR(areaOf(other), area, 1e-12);
        expectChained(other);
    }
    EXPECT_EQ(reversed(reversed(loop, Direction::U), Direction::U), loop);
    EXPECT_EQ(reversed(reversed(loop, Direction::V), Direction::V), loop);
    EXPECT_EQ(swapped(swapped(loop)), loop);
    EXPECT_EQ(reversed(loop, Direction::U).curves[1].points()[1].position, Vec2(-3, 2));
    EXPECT_EQ(reversed(loop, Direction::U).curves[1].points()[1].weight, 0.4);

    const TrimLoop wider = withDomain(loop, Direction::U, 0, 3, 1, 13);
    EXPECT_NEAR(areaOf(wider), 4 * area, 1e-12);
    expectChained(wider);
}

}  // namespace
}  // namespace knotspan
