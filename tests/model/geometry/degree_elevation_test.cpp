#include <algorithm>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "model/geometry/degree_elevation.h"
#include "model/geometry/evaluation.h"
#include "tests/random_surface.h"

namespace knotspan {
namespace {

double inside(const KnotVector& knots, double part)
{
    return knots.domainStart() + part * (knots.domainEnd() - knots.domainStart());
}

// Points and tangents, to 1e-12 of the net's size.
void expectSameShape(const NurbsSurface& raised, const NurbsSurface& original)
{
    const double size = original.bounds().diagonal();
    for (int i = 0; i <= 12; ++i)
        for (int j = 0; j <= 12; ++j) {
            const double u = inside(original.knotsU(), (i + 0.01) / 12.02);
            const double v = inside(original.knotsV(), (j + 0.01) / 12.02);
            const SurfacePoint x = evaluate(raised, u, v);
            const SurfacePoint y = evaluate(original, u, v);
            EXPECT_LE(glm::length(x.position - y.position), 1e-12 * size);
            EXPECT_LE(glm::length(x.du - y.du), 1e-10 * size);
            EXPECT_LE(glm::length(x.dv - y.dv), 1e-10 * size);
        }
}

TEST(DegreeElevation, KeepsTheShapeOfEveryDegreeWithMultipleKnotsAndWeights)
{
    std::mt19937 random(71);
    for (int degree = 1; degree <= 7; ++degree)
        for (const bool rational : {false, true})
            for (const bool clamped : {true, false})
                for (const int times : {1, 2, 5}) {
                    const NurbsSurface surface =
                        testing::randomSurface(random, {.degreeU = degree,
                                                        .degreeV = 1 + (degree + 3) % 7,
                                                        .spans = 5,
                                                        .rational = rational,
                                                        .spanRatio = 20,
                                                        .clamped = clamped});
                    SCOPED_TRACE("degree " + std::to_string(degree) + " raised by " + std::to_string(times));
                    const NurbsSurface inU = withDegree(surface, Direction::U, degree + times);
                    EXPECT_EQ(inU.degreeU(), degree + times);
                    EXPECT_EQ(inU.degreeV(), surface.degreeV());
                    expectSameShape(inU, surface);
                    expectSameShape(withDegree(inU, Direction::V, surface.degreeV() + times), surface);
                }
}

TEST(DegreeElevation, KeepsTheShapeUpToTheHighestDegreeFarFromTheOrigin)
{
    std::mt19937 random(72);
    const NurbsSurface surface =
        testing::randomSurface(random, {.degreeU = 3, .rational = true, .offset = 1e6});
    const NurbsSurface raised = withDegree(surface, Direction::U, kMaxDegree);
    for (int i = 0; i <= 20; ++i) {
        const double u = inside(surface.knotsU(), i / 20.0);
        const double v = inside(surface.knotsV(), 0.37);
        EXPECT_LE(glm::length(evaluate(raised, u, v).position - evaluate(surface, u, v).position), 4e-9);
    }
}

TEST(DegreeElevation, RaisesEachKnotByAsMuchAndKeepsDomainAndCornersToTheBit)
{
    std::mt19937 random(73);
    const NurbsSurface surface = testing::randomSurface(random, {.degreeU = 2, .degreeV = 3, .spans = 4});
    const NurbsSurface raised = withDegree(surface, Direction::U, 4);
    for (const double knot : surface.knotsU().values()) {
        const auto count = [knot](const KnotVector& knots) {
            return std::count(knots.values().begin(), knots.values().end(), knot);
        };
        EXPECT_EQ(count(raised.knotsU()), count(surface.knotsU()) + 2);
    }
    EXPECT_EQ(raised.knotsV(), surface.knotsV());
    for (const int j : {0, surface.countV() - 1}) {
        EXPECT_EQ(raised.controlPoint(0, j), surface.controlPoint(0, j));
        EXPECT_EQ(raised.controlPoint(raised.countU() - 1, j), surface.controlPoint(surface.countU() - 1, j));
    }
}

TEST(DegreeElevation, LeavesAnUnclampedSurfaceOfThatDegreeAsItIs)
{
    std::mt19937 random(74);
    const NurbsSurface surface = testing::randomSurface(random, {.clamped = false});
    EXPECT_EQ(withDegree(surface, Direction::U, 3), surface);
}

TEST(DegreeElevation, MovesControlPointsTowardsTheSurfaceAndNeverOutOfTheNet)
{
    std::mt19937 random(75);
    const NurbsSurface surface =
        testing::randomSurface(random, {.degreeU = 3, .spans = 6, .rational = true, .spanRatio = 1000});
    const Box box = surface.bounds();
    const Box raised = withDegree(surface, Direction::U, 7).bounds();
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(raised.low[axis], box.low[axis] - 1e-12);
        EXPECT_LE(raised.high[axis], box.high[axis] + 1e-12);
    }
}

TEST(KnotInsertion, TakesSeveralKnotsAtOnceInAnyOrder)
{
    std::mt19937 random(76);
    const NurbsSurface surface = testing::randomSurface(random, {.degreeU = 4, .rational = true});
    const double a = inside(surface.knotsU(), 0.21);
    const double b = inside(surface.knotsU(), 0.77);
    const NurbsSurface refined = withKnotsInserted(surface, Direction::U, {b, a, b, b});
    EXPECT_EQ(refined.countU(), surface.countU() + 4);
    expectSameShape(refined, surface);
    EXPECT_EQ(withKnotsInserted(surface, Direction::U, {}), surface);
}

}  // namespace
}  // namespace knotspan
