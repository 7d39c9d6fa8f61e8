// The sampling pass's own text as C++: the grids it chooses, against the measured truth.
#include <gtest/gtest.h>

#include <algorithm>

#include "model/samples/sample_list.h"
#include "tests/grid_sweep.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/random_surface.h"
#include "tests/shaders/chosen_grid.h"

namespace knotspan::testing {
namespace {

constexpr int kHighestU = 9;

struct Sweep : GridSweep {
    long hidden = 0;
    long atOnce = 0;

    void record() const
    {
        GridSweep::record();
        ::testing::Test::RecordProperty("hidden", std::to_string(hidden));
        ::testing::Test::RecordProperty("settled_by_one_window", std::to_string(atOnce));
    }
};

template <class Real>
void measure(std::mt19937& random, const SeenKsQuad& seen, double tolerance, Sweep& sweep)
{
    const ChosenGrid<Real> chosen =
        GridSource<Real>(*seen.surface).choose(seen.number, seen.view, static_cast<Real>(tolerance));
    sweep.hidden += !chosen.visible;
    sweep.atOnce += chosen.visible && chosen.atOnce;
    const Grid& grid = chosen.grid;
    if (!sweep.takes(seen, grid, !chosen.visible || static_cast<double>(chosen.bound) <= tolerance))
        return;
    double error = std::max(errorOfGrid(seen, grid, true), errorOfGrid(seen, grid, false));
    const Vec2 size(1.0 / grid.u, 1.0 / grid.v);
    for (int k = 0; k < 6; ++k) {  // triangles anywhere whose box is as large as a cell
        const Vec2 low(randomBetween(random, 0, 1 - size.x), randomBetween(random, 0, 1 - size.y));
        error = std::max(error, errorOfTriangle(random, seen, low, size));
    }
    if (chosen.visible)
        sweep.judge(error, tolerance, grid);
    else
        EXPECT_EQ(error, 0) << "of a KSQuad that is said not to show";
}

template <class Real>
void measureSamples()
{
    std::mt19937 random(31);
    Sweep sweep;
    sweepSamples(random, viewsOfEach(10), [&](const SeenKsQuad& seen, int, int) {
        for (const double tolerance : kTolerances)
            measure<Real>(random, seen, tolerance, sweep);
    });
    sweep.record();
    EXPECT_GT(sweep.largestShare, 0.8);
    EXPECT_LT(sweep.shareLeftOut(), 0.05);
}

TEST(ChosenGrid, KeepsEverySampleWithinTheToleranceInFloat)
{
    measureSamples<float>();
}

TEST(ChosenGrid, KeepsEverySampleWithinTheToleranceInDouble)
{
    measureSamples<double>();
}

TEST(ChosenGrid, KeepsRandomSurfacesWithinTheToleranceInEveryView)
{
    std::mt19937 random(32);
    Sweep sweep;
    sweepRandomSurfaces(random, viewsOfEach(90), kHighestU, [&](const SeenKsQuad& seen, int trial, int k) {
        measure<float>(random, seen, kTolerances[(trial + k) % 4], sweep);
    });
    sweep.record();
    EXPECT_LT(sweep.shareLeftOut(), 0.2);
}

TEST(ChosenGrid, KeepsWhatShowsOfKsQuadsThroughTheNearPlaneWithinTheTolerance)
{
    std::mt19937 random(33);
    Sweep sweep;
    sweepNearPlane(random, viewsOfEach(90), kHighestU, [&](const SeenKsQuad& seen, int trial, int) {
        measure<float>(random, seen, kTolerances[trial % 4], sweep);
    });
    sweep.record();
    EXPECT_GT(sweep.crossingNear, 20);
    EXPECT_LT(static_cast<double>(sweep.notKept), 0.5 * static_cast<double>(sweep.ksQuadViews));
}

struct Spent {
    long ours = 0;
    long smallest = 0;

    [[nodiscard]] double ratio() const { return static_cast<double>(ours) / static_cast<double>(smallest); }
};

// Cells, at 0.5 pixels, against the smallest grid that measures within, of the KSQuads that show.
TEST(ChosenGrid, SpendsLittleMoreThanTheSmallestGridThatMeasuresWithin)
{
    std::mt19937 random(34);
    std::vector<double> ratios;
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        const auto quads = ksQuadsOf(scene);
        Spent spent;
        for (int k = 0; k < viewsOfEach(60); ++k) {
            const RandomView view = randomView(random, scene.bounds(), Vec3(0), false, k % 4 == 3);
            const SeenKsQuad seen = seenIn(view, quads[random() % quads.size()]);
            const auto chosen = GridSource<float>(*seen.surface).choose(seen.number, seen.view, 0.5F);
            if (!chosen.visible || chosen.grid.cells() > 100)
                continue;
            const auto best = smallestMeasuredGrid(seen.net, seen.view, 0.5, false, chosen.grid.cells());
            ASSERT_TRUE(best);
            spent.ours += chosen.grid.cells();
            spent.smallest += best->cells();
        }
        if (spent.smallest == 0)  // all its KSQuads are too large in these views
            continue;
        RecordProperty(sample.name, std::to_string(spent.ratio()));
        ratios.push_back(spent.ratio());
    }
    ASSERT_GE(ratios.size(), 5U);
    std::sort(ratios.begin(), ratios.end());
    EXPECT_LE(ratios[ratios.size() / 2], 1.6);
    EXPECT_LE(ratios.back(), 1.8);
}

}  // namespace
}  // namespace knotspan::testing
