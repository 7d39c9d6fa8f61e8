// Sweeps over KSQuads in views, for tests of who chooses grids: what is looked at, and what is found there.
#pragma once

#include <functional>
#include <random>

#include "tests/ksquad_views.h"

namespace knotspan::testing {

constexpr double kTolerances[] = {0.25, 0.5, 1, 4};
constexpr double kRounding = 1 + 1e-9;

// How many views of each model: KNOTSPAN_SWEEP=100 for the whole sweep.
[[nodiscard]] int viewsOfEach(int normally);

// Of any degrees up to `highestU` and 7, with all that knots and weights can be.
[[nodiscard]] NurbsSurface anySurface(std::mt19937& random, int trial, int highestU);

// Called with which view, and which KSQuad in it.
using Visit = std::function<void(const SeenKsQuad& seen, int view, int pick)>;

// Five KSQuads in each view of each sample: some views from close by, some without perspective.
void sweepSamples(std::mt19937& random, int views, const Visit& visit);
// Four views of each of `trials` surfaces; `view` is the trial, `pick` one of the four.
void sweepRandomSurfaces(std::mt19937& random, int trials, int highestU, const Visit& visit);
// One view from among the points of a KSQuad of each of `trials` surfaces.
void sweepNearPlane(std::mt19937& random, int trials, int highestU, const Visit& visit);

// The largest error of the grid's triangles, on one diagonal, at more points where there are fewer cells.
[[nodiscard]] double errorOfGrid(const SeenKsQuad& seen, const Grid& grid, bool rising);
// Of one triangle with its corners anywhere on the border of a box of parameters, as those that stitch.
[[nodiscard]] double errorOfTriangle(std::mt19937& random, const SeenKsQuad& seen, const Vec2& low,
                                     const Vec2& size);

// What a sweep saw.
struct GridSweep {
    long ksQuadViews = 0;
    long crossingNear = 0;
    long notKept = 0;
    long notMeasured = 0;
    long violations = 0;
    double largestShare = 0;  // of the tolerance

    // Counts a choice in; whether its grid is to be measured: it claims the tolerance and is not huge.
    [[nodiscard]] bool takes(const SeenKsQuad& seen, const Grid& grid, bool kept);
    // Expects an error within the tolerance.
    void judge(double error, double tolerance, const Grid& grid);
    [[nodiscard]] double shareLeftOut() const;
    // Prints into the results, and expects that no error was beyond its tolerance.
    void record() const;
};

}  // namespace knotspan::testing
