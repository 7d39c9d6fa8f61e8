#include "tests/grid_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "model/analysis/net_on_screen.h"
#include "model/samples/sample_list.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

int viewsOfEach(int normally)
{
    const char* sweep = std::getenv("KNOTSPAN_SWEEP");
    return sweep ? std::max(normally, std::atoi(sweep)) : normally;
}

NurbsSurface anySurface(std::mt19937& random, int trial, int highestU)
{
    return randomSurface(random, {.degreeU = 1 + trial % highestU,
                                  .degreeV = 1 + (trial * 5) % 7,
                                  .spans = 2,
                                  .rational = trial % 3 != 0,
                                  .spanRatio = trial % 4 == 0 ? 1e3 : 4.0,
                                  .clamped = trial % 5 != 0,
                                  .weightRatio = trial % 7 == 0 ? 100.0 : 4.0});
}

void sweepSamples(std::mt19937& random, int views, const Visit& visit)
{
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        const auto quads = ksQuadsOf(scene);
        for (int k = 0; k < views; ++k) {
            const RandomView view = randomView(random, scene.bounds(), Vec3(0), k % 3 == 2, k % 5 == 4);
            for (int n = 0; n < 5; ++n)
                visit(seenIn(view, quads[random() % quads.size()]), k, n);
        }
    }
}

void sweepRandomSurfaces(std::mt19937& random, int trials, int highestU, const Visit& visit)
{
    for (int trial = 0; trial < trials; ++trial) {
        const NurbsSurface surface = anySurface(random, trial, highestU);
        for (int k = 0; k < 4; ++k) {
            const RandomView view = randomView(random, surface.bounds(), Vec3(0), k % 2 == 1, k == 2);
            visit(seenIn(view, randomKsQuad(random, surface)), trial, k);
        }
    }
}

void sweepNearPlane(std::mt19937& random, int trials, int highestU, const Visit& visit)
{
    for (int trial = 0; trial < trials; ++trial) {
        const NurbsSurface surface = anySurface(random, trial, highestU);
        const PlacedKsQuad placed = randomKsQuad(random, surface);
        visit(seenIn(viewFromAmong(random, placed), placed), trial, 0);
    }
}

double errorOfGrid(const SeenKsQuad& seen, const Grid& grid, bool rising)
{
    const int samples = std::max(grid.cells() > 400 ? 2 : 4, 12 / std::max(grid.u, grid.v));
    return measuredError(seen.net, seen.view, grid, rising, samples);
}

double errorOfTriangle(std::mt19937& random, const SeenKsQuad& seen, const Vec2& low, const Vec2& size)
{
    Vec2 corners[3];
    for (Vec2& corner : corners) {
        corner = {randomBetween(random, 0, 1), randomBetween(random, 0, 1)};
        const auto axis = static_cast<int>(random() % 2);
        corner[axis] = std::round(corner[axis]);
        corner = low + size * corner;
    }
    return measuredError(seen.net, seen.view, corners, 8);
}

bool GridSweep::takes(const SeenKsQuad& seen, const Grid& grid, bool kept)
{
    constexpr long kMostCells = 40000;
    const NetOnScreen on(seen.net, seen.view);
    ++ksQuadViews;
    crossingNear += on.visible && !on.inFront;
    notKept += !kept;
    notMeasured += kept && grid.cells() > kMostCells;
    return kept && grid.cells() <= kMostCells;
}

void GridSweep::judge(double error, double tolerance, const Grid& grid)
{
    largestShare = std::max(largestShare, error / tolerance);
    violations += !(error <= tolerance * kRounding);
    EXPECT_LE(error, tolerance * kRounding) << grid.u << " x " << grid.v << " cells";
}

double GridSweep::shareLeftOut() const
{
    return static_cast<double>(notKept + notMeasured) / static_cast<double>(ksQuadViews);
}

void GridSweep::record() const
{
    const auto property = [](const char* name, auto value) {
        ::testing::Test::RecordProperty(name, std::to_string(value));
    };
    property("ksquad_views", ksQuadViews);
    property("crossing_near", crossingNear);
    property("not_kept", notKept);
    property("not_measured", notMeasured);
    property("largest_share_of_tolerance", largestShare);
    EXPECT_EQ(violations, 0);
}

}  // namespace knotspan::testing
