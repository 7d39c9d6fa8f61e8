#include "model/analysis/grid_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/samples/sample_list.h"
#include "tests/grid_sweep.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

constexpr int kHighestU = 6;

void measure(const SeenKsQuad& seen, double tolerance, Triangles triangles, GridSweep& sweep)
{
    const GridChoice choice = chooseGrid(seen.net, seen.view, tolerance, triangles, 1024);
    if (!sweep.takes(seen, choice.grid, choice.kept))
        return;
    double error = 0;
    for (const bool rising : {true, false})
        if (triangles == Triangles::eitherDiagonal || rising == (triangles == Triangles::risingDiagonal))
            error = std::max(error, errorOfGrid(seen, choice.grid, rising));
    sweep.judge(error, tolerance, choice.grid);
}

TEST(GridChoice, KeepsEverySampleWithinTheToleranceInEveryView)
{
    std::mt19937 random(21);
    GridSweep sweep;
    sweepSamples(random, viewsOfEach(10), [&](const SeenKsQuad& seen, int view, int pick) {
        const Triangles oneWay = view % 2 == 0 ? Triangles::risingDiagonal : Triangles::fallingDiagonal;
        for (const double tolerance : kTolerances)
            measure(seen, tolerance, pick % 2 == 0 ? Triangles::eitherDiagonal : oneWay, sweep);
    });
    sweep.record();
    EXPECT_GT(sweep.largestShare, 0.9);
    EXPECT_LT(sweep.shareLeftOut(), 0.05);
}

TEST(GridChoice, KeepsWhatShowsOfKsQuadsThroughTheNearPlaneWithinTheTolerance)
{
    std::mt19937 random(26);
    GridSweep sweep;
    sweepNearPlane(random, viewsOfEach(60), kHighestU, [&](const SeenKsQuad& seen, int trial, int) {
        measure(seen, kTolerances[trial % 4], Triangles::eitherDiagonal, sweep);
    });
    sweep.record();
    EXPECT_GT(sweep.crossingNear, 15);
    EXPECT_LT(static_cast<double>(sweep.notKept), 0.2 * static_cast<double>(sweep.ksQuadViews));
}

TEST(GridChoice, KeepsRandomSurfacesWithinTheTolerance)
{
    std::mt19937 random(22);
    GridSweep sweep;
    sweepRandomSurfaces(random, viewsOfEach(40), kHighestU, [&](const SeenKsQuad& seen, int trial, int k) {
        measure(seen, kTolerances[(trial + k) % 4],
                trial % 2 == 0 ? Triangles::eitherDiagonal : Triangles::risingDiagonal, sweep);
    });
    sweep.record();
    EXPECT_LT(sweep.shareLeftOut(), 0.1);
}

TEST(GridChoice, ForAnyTrianglesHoldsForEachThatFitsIntoACell)
{
    std::mt19937 random(23);
    int kept = 0;
    for (int trial = 0; trial < viewsOfEach(30); ++trial) {
        const NurbsSurface surface = anySurface(random, trial, kHighestU);
        const RandomView view = randomView(random, surface.bounds(), Vec3(0), trial % 3 == 2, false);
        const SeenKsQuad seen = seenIn(view, randomKsQuad(random, surface));
        const GridChoice choice = chooseGrid(seen.net, seen.view, 1.0, Triangles::any, 1024);
        if (!choice.kept)
            continue;
        ++kept;
        for (int k = 0; k < 40; ++k) {
            const Vec2 cells(choice.grid.u, choice.grid.v);
            const Vec2 cell(std::floor(randomBetween(random, 0, cells.x)),
                            std::floor(randomBetween(random, 0, cells.y)));
            EXPECT_LE(errorOfTriangle(random, seen, cell / cells, 1.0 / cells), kRounding);
        }
    }
    EXPECT_GT(kept, 20);
}

TEST(GridChoice, SpendsLittleMoreThanTheSmallestGridThatMeasuresWithin)
{
    std::mt19937 random(24);
    std::vector<double> ratios;
    std::vector<double> closedForm;
    long ours = 0;
    long smallest = 0;
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        const auto quads = ksQuadsOf(scene);
        for (int k = 0; k < viewsOfEach(12); ++k) {
            const RandomView view = randomView(random, scene.bounds(), Vec3(0), false, k % 4 == 3);
            const SeenKsQuad seen = seenIn(view, quads[random() % quads.size()]);
            const Grid chosen = chooseGrid(seen.net, seen.view, 0.5, Triangles::risingDiagonal).grid;
            const auto figures = errorFigures(seen.net, 2);
            if (!figures || chosen.cells() < 2 || chosen.cells() > 100)
                continue;
            const auto best = smallestMeasuredGrid(seen.net, seen.view, 0.5, true, chosen.cells());
            ASSERT_TRUE(best);
            ours += chosen.cells();
            smallest += best->cells();
            ratios.push_back(static_cast<double>(chosen.cells()) / static_cast<double>(best->cells()));
            closedForm.push_back(static_cast<double>(smallestGrid(*figures, 0.5)->cells()) /
                                 static_cast<double>(best->cells()));
        }
    }
    ASSERT_GT(ratios.size(), 20u);
    const auto median = [](std::vector<double> values) {
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    };
    RecordProperty("median", std::to_string(median(ratios)));
    RecordProperty("median_of_closed_form", std::to_string(median(closedForm)));
    RecordProperty("total", std::to_string(static_cast<double>(ours) / static_cast<double>(smallest)));
    EXPECT_LE(median(ratios), 1.2);
    EXPECT_LE(static_cast<double>(ours), 1.4 * static_cast<double>(smallest));
    EXPECT_LT(median(ratios), median(closedForm));
}

BezierNet bent(double depth)
{
    BezierNet net{2, 2, {}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            net.points.push_back(
                {depth * (400 + 100 * i), depth * (400 + 100 * j + (i == 1 ? 80 : 0)), 0.1, depth});
    return net;
}

const ScreenView kPicture{Mat4(1.0), Vec2(0), Vec2(1920, 1080)};

TEST(GridChoice, AsksForNothingWhereNothingShows)
{
    const GridChoice behind = chooseGrid(bent(0.05), kPicture, 0.5);  // nearer than the near plane
    EXPECT_FALSE(behind.visible);
    EXPECT_EQ(behind.grid, Grid{});
    EXPECT_FALSE(chooseGrid(bent(-1), kPicture, 0.5).visible);
    EXPECT_FALSE(chooseGrid(bent(1), ScreenView{Mat4(1.0), Vec2(700, 0), Vec2(1920, 1080)}, 0.5).visible);
    const GridChoice shown = chooseGrid(bent(1), kPicture, 0.5);
    EXPECT_TRUE(shown.visible);
    EXPECT_GT(shown.grid.u, 3);
    EXPECT_EQ(shown.grid.v, 1);
}

// Straight along u, from w = 1 through the near plane to w = 0; bent along v.
TEST(GridChoice, IsExactAtTheNearPlaneWhereWIsLinear)
{
    BezierNet net{1, 2, {}};
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 3; ++j)
            net.points.push_back({50 + 20 * j, j == 1 ? 48 : 40, 0.1, 1 - i});
    const GridChoice choice = chooseGrid(net, kPicture, 0.5);
    ASSERT_TRUE(choice.kept);
    EXPECT_EQ(choice.grid, (Grid{1, 9}));  // 4 / 0.1 pixels off at one cell
    for (const bool rising : {true, false})
        EXPECT_LE(measuredError(net, kPicture, choice.grid, rising, 100), 0.5 * kRounding);
    EXPECT_GT(measuredError(net, kPicture, {1, 8}, true, 100), 0.5);
}

// The ends lie on the near plane, so all of the chord shows; the surface's own w is half of that.
TEST(GridChoice, CountsWithTheSurfaceBehindATriangleOnTheNearPlane)
{
    BezierNet net{1, 2, {}};
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 3; ++j)
            net.points.push_back(0.1 * Vec4(50, i - 0.5, 1, j == 1 ? 0 : 1));
    const ScreenView view{Mat4(1.0), Vec2(40, -10), Vec2(60, 10)};
    EXPECT_GT(measuredError(net, view, {1, 1}, true, 20), 50);
    EXPECT_FALSE(keepsTolerance(net, view, {1, 1}, 40, Triangles::eitherDiagonal));
    EXPECT_TRUE(keepsTolerance(net, view, {1, 1}, 70, Triangles::eitherDiagonal));
}

TEST(GridChoice, SaysWhenTheLargestFactorIsNotEnough)
{
    const GridChoice choice = chooseGrid(bent(1), kPicture, 0.01, Triangles::eitherDiagonal, 4);
    EXPECT_FALSE(choice.kept);
    EXPECT_EQ(choice.grid, (Grid{4, 4}));
    EXPECT_TRUE(chooseGrid(bent(1), kPicture, 0.01).kept);
}

TEST(GridChoice, GrowsWithLessEffortAndStillKeepsTheTolerance)
{
    std::mt19937 random(25);
    for (int trial = 0; trial < 10; ++trial) {
        const NurbsSurface surface = anySurface(random, trial, kHighestU);
        const RandomView view = randomView(random, surface.bounds(), Vec3(0), false, false);
        const SeenKsQuad seen = seenIn(view, {&surface, Mat4(1.0), 0});
        for (const ProofEffort effort : {ProofEffort{0, -1}, ProofEffort{4, 1}}) {
            const GridChoice choice =
                chooseGrid(seen.net, seen.view, 0.5, Triangles::eitherDiagonal, kLargestFactor, effort);
            ASSERT_TRUE(choice.kept);
            EXPECT_TRUE(keepsTolerance(seen.net, seen.view, choice.grid, 0.5, Triangles::eitherDiagonal));
            if (choice.grid.cells() < 3000) {
                for (const bool rising : {true, false})
                    EXPECT_LE(measuredError(seen.net, seen.view, choice.grid, rising, 4), 0.5 * kRounding);
            }
        }
    }
}

}  // namespace
}  // namespace knotspan::testing
