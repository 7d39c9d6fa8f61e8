#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/evaluation.h"
#include "model/geometry/knot_insertion.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

// Over the domain of `part`, which lies in the other's.
void expectSameShape(const NurbsSurface& part, const NurbsSurface& whole, double tolerance)
{
    const KnotVector& u = part.knotsU();
    const KnotVector& v = part.knotsV();
    for (int i = 0; i <= 10; ++i)
        for (int j = 0; j <= 10; ++j) {
            const double a = u.domainStart() + (u.domainEnd() - u.domainStart()) * (i + 0.01) / 10.02;
            const double b = v.domainStart() + (v.domainEnd() - v.domainStart()) * (j + 0.01) / 10.02;
            const SurfacePoint x = evaluate(part, a, b);
            const SurfacePoint y = evaluate(whole, a, b);
            EXPECT_LE(glm::length(x.position - y.position), tolerance);
            EXPECT_LE(glm::length(x.du - y.du), tolerance * (1 + 100 * glm::length(y.du)));
        }
}

double inside(const KnotVector& knots, double part)
{
    return knots.domainStart() + part * (knots.domainEnd() - knots.domainStart());
}

TEST(KnotInsertion, KeepsTheShape)
{
    std::mt19937 random(7);
    for (const int degree : {1, 2, 3, 5, 9, 15})
        for (const bool clamped : {true, false}) {
            const NurbsSurface surface =
                testing::randomSurface(random, {.degreeU = degree, .rational = true, .clamped = clamped});
            const NurbsSurface inU = withKnotInserted(surface, Direction::U, inside(surface.knotsU(), 0.37));
            const NurbsSurface inV = withKnotInserted(inU, Direction::V, inside(surface.knotsV(), 0.52), 3);
            EXPECT_EQ(inV.countU(), surface.countU() + 1);
            EXPECT_EQ(inV.countV(), surface.countV() + 3);
            expectSameShape(inV, surface, 1e-11);
        }
}

TEST(KnotInsertion, PutsAControlPointOnTheSurfaceAfterDegreeCopies)
{
    std::mt19937 random(8);
    const NurbsSurface surface = testing::randomSurface(random, {.degreeU = 3, .degreeV = 2});
    const double u = inside(surface.knotsU(), 0.41);
    const NurbsSurface refined = withKnotInserted(surface, Direction::U, u, 3);
    const int k = refined.knotsU().findSpan(u);
    EXPECT_LE(glm::length(refined.controlPoint(k - 3, 0).position -
                          evaluate(surface, u, surface.knotsV().domainStart()).position),
              1e-13);
}

TEST(KnotInsertion, CutsPartsThatKeepTheShapeAndTheirParameters)
{
    std::mt19937 random(9);
    for (const int degree : {1, 2, 3, 7})
        for (const bool clamped : {true, false}) {
            const NurbsSurface surface =
                testing::randomSurface(random, {.degreeU = degree, .rational = true, .clamped = clamped});
            const double start = inside(surface.knotsU(), 0.2);
            const double end = inside(surface.knotsU(), 0.75);
            const NurbsSurface part = clampedPart(surface, Direction::U, start, end);
            EXPECT_EQ(part.knotsU().domainStart(), start);
            EXPECT_EQ(part.knotsU().domainEnd(), end);
            EXPECT_EQ(part.knotsU().values().front(), start);
            EXPECT_EQ(part.knotsU().values().back(), end);
            expectSameShape(part, surface, 1e-11);
        }
}

TEST(KnotInsertion, LeavesAClampedSurfaceAsItIsWhenAllOfItIsCut)
{
    std::mt19937 random(10);
    const NurbsSurface surface =
        testing::randomSurface(random, {.degreeU = 3, .degreeV = 4, .rational = true});
    EXPECT_EQ(
        clampedPart(surface, Direction::V, surface.knotsV().domainStart(), surface.knotsV().domainEnd()),
        surface);
}

TEST(KnotInsertion, LetsTwoPartsMeetAtTheirCut)
{
    std::mt19937 random(11);
    const NurbsSurface surface =
        testing::randomSurface(random, {.degreeU = 4, .degreeV = 3, .rational = true, .clamped = false});
    const double cut = inside(surface.knotsU(), 0.44);
    const NurbsSurface left = clampedPart(surface, Direction::U, surface.knotsU().domainStart(), cut);
    const NurbsSurface right = clampedPart(surface, Direction::U, cut, surface.knotsU().domainEnd());
    for (int j = 0; j < surface.countV(); ++j)
        EXPECT_LE(
            glm::length(left.controlPoint(left.countU() - 1, j).position - right.controlPoint(0, j).position),
            1e-13);
}

}  // namespace
}  // namespace knotspan
