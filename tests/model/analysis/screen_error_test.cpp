#include "model/analysis/screen_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/analysis/net_on_screen.h"
#include "model/geometry/evaluation.h"
#include "model/geometry/primitives.h"
#include "tests/ksquad_views.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

const ScreenView kPlain{Mat4(1.0), Vec2(-1e6), Vec2(1e6)};

// Points (x, y, 0, w) over the unit square, with some relief on the screen.
BezierNet randomNet(std::mt19937& random, int degreeU, int degreeV, bool rational)
{
    BezierNet net{degreeU, degreeV, {}};
    for (int i = 0; i <= degreeU; ++i)
        for (int j = 0; j <= degreeV; ++j) {
            const double w = rational ? randomBetween(random, 0.5, 2) : 1.0;
            net.points.push_back(w * Vec4(100.0 * i / degreeU + randomBetween(random, -20, 20),
                                          100.0 * j / degreeV + randomBetween(random, -20, 20), 0, 1));
        }
    return net;
}

TEST(ScreenView, FoldsTheViewportIntoTheMatrix)
{
    std::mt19937 random(1);
    const NurbsSurface surface = sphere(Vec3(3, 2, 1), 2.0);
    const RandomView view = randomView(random, surface.bounds(), Vec3(0), false, false);
    const BezierConversion conversion(surface);
    for (const KsQuad& quad : ksQuads(surface)) {
        const Vec4 found = evaluate(transformed(conversion.net(quad), view.view.toPixels), 0.5, 0.5);
        const double u = 0.5 * (surface.knotsU()[quad.spanU] + surface.knotsU()[quad.spanU + 1]);
        const double v = 0.5 * (surface.knotsV()[quad.spanV] + surface.knotsV()[quad.spanV + 1]);
        const Vec4 clip = view.toClip * Vec4(evaluate(surface, u, v).position, 1);
        EXPECT_NEAR(found.x / found.w, (clip.x / clip.w + 1) * 960, 1e-9);
        EXPECT_NEAR(found.y / found.w, (clip.y / clip.w + 1) * 540, 1e-9);
        EXPECT_NEAR(found.z / found.w, clip.z / clip.w, 1e-12);
    }
}

TEST(ErrorFigures, AreNeverExceededByTheGridsTheyAllow)
{
    std::mt19937 random(2);
    for (int trial = 0; trial < 60; ++trial) {
        const BezierNet net = randomNet(random, 1 + trial % 5, 1 + (trial / 5) % 4, trial % 2 == 1);
        for (const int subdivisions : {0, 1, 2})
            for (const FigureForm form : {FigureForm::tight, FigureForm::cheap}) {
                const auto figures = errorFigures(net, subdivisions, form);
                ASSERT_TRUE(figures);
                for (const Grid grid : {Grid{1, 1}, Grid{3, 2}, Grid{2, 5}})
                    for (const bool rising : {true, false})
                        EXPECT_LE(measuredError(net, kPlain, grid, rising, 8),
                                  figures->errorBound(grid) * (1 + 1e-12) + 1e-12);
            }
    }
}

// One cell over the whole net lies over all parts of the subdivision. Where the second derivative is large, w
// is not small: s and w of each part beside its own derivatives would promise too much.
TEST(ErrorFigures, HoldForACellThatLiesOverSeveralParts)
{
    BezierNet net{3, 1, {}};
    for (const Vec3& point : {Vec3(-127.5, 33.77, 0.2625), Vec3(-101.3, 22.27, 2.125),
                              Vec3(-31.58, 52.52, 0.7467), Vec3(-68.03, -348.1, 0.8391)})
        for (int j = 0; j < 2; ++j)
            net.points.push_back(point.z * Vec4(point.x, point.y, 0, 1));
    const double measured = measuredError(net, kPlain, {1, 1}, true, 16);
    ErrorFigures partByPart;
    BezierNet rest = net;
    for (int parts = 4; parts > 0; --parts) {
        auto [part, others] = split(rest, Direction::U, 1.0 / parts);
        partByPart.a = std::max(partByPart.a, 16 * errorFigures(parts == 1 ? rest : part)->a);
        rest = std::move(others);
    }
    EXPECT_GT(measured, 1.15 * partByPart.errorBound({1, 1}));
    for (const int subdivisions : {0, 1, 2, 3, 4})
        EXPECT_LE(measured, errorFigures(net, subdivisions)->errorBound({1, 1}));
}

TEST(ErrorFigures, ShrinkWithSubdivisionAndAreLargerInTheCheapForm)
{
    std::mt19937 random(3);
    for (int trial = 0; trial < 20; ++trial) {
        const BezierNet net = randomNet(random, 3, 2 + trial % 3, true);
        ErrorFigures before = *errorFigures(net, 0);
        for (int subdivisions = 0; subdivisions < 4; ++subdivisions) {
            const ErrorFigures tight = *errorFigures(net, subdivisions, FigureForm::tight);
            const ErrorFigures cheap = *errorFigures(net, subdivisions, FigureForm::cheap);
            for (const double ErrorFigures::*figure :
                 {&ErrorFigures::a, &ErrorFigures::b, &ErrorFigures::c}) {
                EXPECT_LE(tight.*figure, cheap.*figure * (1 + 1e-12));
                EXPECT_LE(tight.*figure, before.*figure * (1 + 1e-12));
            }
            before = tight;
        }
    }
}

TEST(ErrorFigures, DoNotExistWhereAControlPointIsNotInFrontOfTheEye)
{
    std::mt19937 random(4);
    BezierNet net = randomNet(random, 2, 2, false);
    ASSERT_TRUE(errorFigures(net));
    net.at(1, 2).w = 0;
    EXPECT_FALSE(errorFigures(net));
    net.at(1, 2).w = -1;
    EXPECT_FALSE(errorFigures(net, 2, FigureForm::cheap));
}

TEST(SmallestGrid, HasTheFewestCellsOfAllGridsWithinTheBound)
{
    std::mt19937 random(5);
    for (int trial = 0; trial < 300; ++trial) {
        const auto figure = [&] {
            return trial % 7 == 0 ? 0.0 : std::pow(10, randomBetween(random, -1, 2.5));
        };
        const ErrorFigures figures{figure(),
                                   trial % 5 == 0 ? 0.0 : std::pow(10, randomBetween(random, -1, 2)),
                                   trial % 3 == 0 ? 0.0 : figure()};
        const double tolerance = std::pow(4, trial % 3) * 0.25;
        const auto found = smallestGrid(figures, tolerance);
        ASSERT_TRUE(found);
        EXPECT_LE(figures.errorBound(*found), tolerance);
        for (int u = 1; u < found->cells(); ++u) {
            const int v = static_cast<int>((found->cells() - 1) / u);
            EXPECT_GT(figures.errorBound({u, v}), tolerance) << u << " x " << v;
        }
    }
}

TEST(SmallestGrid, DoesNotExistBeyondTheLargestFactor)
{
    EXPECT_FALSE(smallestGrid({1e6, 0, 1}, 0.25, 64));
    EXPECT_EQ(smallestGrid({1e6, 0, 0}, 0.25, 1000), (Grid{708, 1}));
}

TEST(SmallestGrid, NeedsOneCellAlongTheRulingsOfACylinder)
{
    std::mt19937 random(6);
    BezierNet ruled{1, 4, {}};
    for (int j = 0; j <= 4; ++j)
        ruled.points.push_back(Vec4(30 * j, randomBetween(random, -50, 50), 0, 1));
    for (int j = 0; j <= 4; ++j)
        ruled.points.push_back(ruled.points[static_cast<size_t>(j)] + Vec4(10, 80, 0, 0));
    const auto grid = smallestGrid(*errorFigures(ruled, 2), 0.5);
    ASSERT_TRUE(grid);
    EXPECT_EQ(grid->u, 1);
    EXPECT_GT(grid->v, 3);
}

BezierNet reversed(BezierNet curve)
{
    std::reverse(curve.points.begin(), curve.points.end());
    return curve;
}

BezierNet randomCurve(std::mt19937& random, int degree, bool closed)
{
    BezierNet curve = boundary(randomNet(random, degree, 1, true), Side::startV);
    if (closed)
        curve.points.back() = curve.points.front();
    return curve;
}

TEST(EdgeFactor, IsTheSameFromBothSides)
{
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        const BezierNet curve = randomCurve(random, 1 + trial % 9, trial % 4 == 0);
        const double tolerance = 0.05;
        EXPECT_EQ(edgeFactor(curve, kPlain, tolerance), edgeFactor(reversed(curve), kPlain, tolerance));
    }
}

TEST(EdgeFactor, KeepsTheVisibleEdgeWithinTheTolerance)
{
    std::mt19937 random(8);
    int several = 0;
    for (int trial = 0; trial < 200; ++trial) {
        BezierNet curve = randomCurve(random, 1 + trial % 6, false);
        if (trial % 3 == 2) {  // its end comes through the near plane
            for (int k = 0; k <= curve.degreeU; ++k)
                curve.at(k, 0).w *= 1 - 1.1 * k / curve.degreeU;
            for (Vec4& point : curve.points)
                point.z = 0.05;
        }
        const ScreenView view{Mat4(1.0), Vec2(-20), Vec2(200)};
        const int cells = edgeFactor(curve, view, 0.5);
        ASSERT_LT(cells, kLargestFactor);
        several += cells > 1;
        for (int k = 0; k < cells; ++k) {
            const Vec2 corners[3] = {{static_cast<double>(k) / cells, 0},
                                     {static_cast<double>(k + 1) / cells, 0},
                                     {static_cast<double>(k + 1) / cells, 0}};
            EXPECT_LE(measuredError(curve, view, corners, 8), 0.5 * (1 + 1e-9));
        }
    }
    EXPECT_GT(several, 100);
}

TEST(EdgeFactor, IsNotOneWhereTheChordShowsAndTheCurveIsBehindTheEye)
{
    BezierNet curve{2, 0, {}};
    for (const double w : {0.1, -0.3, 0.1})
        curve.points.push_back({5, 5, 0.1, w});
    const ScreenView view{Mat4(1.0), Vec2(0), Vec2(100)};
    const Vec2 chord[3] = {{0, 0}, {1, 0}, {1, 0}};
    EXPECT_EQ(measuredError(curve, view, chord, 10), std::numeric_limits<double>::infinity());
    EXPECT_GT(edgeFactor(curve, view, 1e6), 1);
}

TEST(EdgeFactor, StopsAtTheLargest)
{
    std::mt19937 random(9);
    EXPECT_EQ(edgeFactor(randomCurve(random, 4, false), kPlain, 1e-6, 64), 64);
}

}  // namespace
}  // namespace knotspan::testing
