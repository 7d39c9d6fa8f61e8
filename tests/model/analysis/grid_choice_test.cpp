#include "model/analysis/grid_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/analysis/net_on_screen.h"
#include "model/samples/sample_list.h"
#include "tests/model/analysis/measured_error.h"
#include "tests/random_surface.h"

namespace knotspan::testing {
namespace {

constexpr double kTolerances[] = {0.25, 0.5, 1, 4};
constexpr double kRounding = 1 + 1e-9;

// How many views of each model: KNOTSPAN_SWEEP=100 for the whole sweep.
int viewsOfEach(int normally)
{
    const char* sweep = std::getenv("KNOTSPAN_SWEEP");
    return sweep ? std::max(normally, std::atoi(sweep)) : normally;
}

struct PlacedKsQuad {
    const NurbsSurface* surface;
    Mat4 transform;
    KsQuad quad;
};

std::vector<PlacedKsQuad> ksQuadsOf(const Scene& scene)
{
    std::vector<PlacedKsQuad> result;
    for (const auto& [id, object] : scene.objects())
        for (const KsQuad& quad : ksQuads(object->surface))
            result.push_back({&object->surface, object->transform, quad});
    return result;
}

struct SeenNet {
    BezierNet net;
    ScreenView view;
};

// Relative to the surface's centre, so that digits are left far from the origin.
SeenNet seenNet(const PlacedKsQuad& placed, const RandomView& random)
{
    const Vec3 origin = placed.surface->bounds().centre();
    Mat4 shift(1.0);
    shift[3] = Vec4(origin, 1);
    const ScreenView view = screenView(random.toClip * placed.transform * shift, 1920, 1080);
    return {transformed(BezierConversion(*placed.surface, origin).net(placed.quad), view.toPixels), view};
}

// What a sweep saw; printed into the results.
struct Sweep {
    long ksQuadViews = 0;
    long violations = 0;
    long crossingNear = 0;
    long notKept = 0;
    long notMeasured = 0;
    double largestShare = 0;  // of the tolerance

    void record() const
    {
        ::testing::Test::RecordProperty("ksquad_views", std::to_string(ksQuadViews));
        ::testing::Test::RecordProperty("crossing_near", std::to_string(crossingNear));
        ::testing::Test::RecordProperty("not_kept", std::to_string(notKept));
        ::testing::Test::RecordProperty("not_measured", std::to_string(notMeasured));
        ::testing::Test::RecordProperty("largest_share_of_tolerance", std::to_string(largestShare));
    }
};

void measure(const SeenNet& seen, double tolerance, Triangles triangles, Sweep& sweep)
{
    const NetOnScreen on(seen.net, seen.view);
    const GridChoice choice = chooseGrid(seen.net, seen.view, tolerance, triangles, 1024);
    ++sweep.ksQuadViews;
    sweep.crossingNear += on.visible && !on.inFront;
    if (!choice.kept) {
        ++sweep.notKept;
        return;
    }
    const Grid& grid = choice.grid;
    if (grid.cells() > 40000) {
        ++sweep.notMeasured;
        return;
    }
    const int samples = std::max(grid.cells() > 400 ? 2 : 4, 12 / std::max(grid.u, grid.v));
    double error = 0;
    for (const bool rising : {true, false})
        if (triangles == Triangles::eitherDiagonal || rising == (triangles == Triangles::risingDiagonal))
            error = std::max(error, measuredError(seen.net, seen.view, grid, rising, samples));
    sweep.largestShare = std::max(sweep.largestShare, error / tolerance);
    sweep.violations += !(error <= tolerance * kRounding);
    EXPECT_LE(error, tolerance * kRounding) << grid.u << " x " << grid.v << " cells";
}

TEST(GridChoice, KeepsEverySampleWithinTheToleranceInEveryView)
{
    std::mt19937 random(21);
    Sweep sweep;
    for (const Sample& sample : samples()) {
        const Scene scene = sample.make();
        const auto quads = ksQuadsOf(scene);
        for (int k = 0; k < viewsOfEach(10); ++k) {
            const RandomView view = randomView(random, scene.bounds(), Vec3(0), k % 3 == 2, k % 5 == 4);
            for (int n = 0; n < 5; ++n) {
                const SeenNet seen = seenNet(quads[random() % quads.size()], view);
                for (const double tolerance : kTolerances)
                    measure(seen, tolerance,
                            n % 2 == 0   ? Triangles::eitherDiagonal
                            : k % 2 == 0 ? Triangles::risingDiagonal
                                         : Triangles::fallingDiagonal,
                            sweep);
            }
        }
    }
    sweep.record();
    EXPECT_EQ(sweep.violations, 0);
    EXPECT_GT(sweep.largestShare, 0.9);
    EXPECT_LT(static_cast<double>(sweep.notMeasured + sweep.notKept),
              0.05 * static_cast<double>(sweep.ksQuadViews));
}

NurbsSurface anySurface(std::mt19937& random, int trial)
{
    return randomSurface(random, {.degreeU = 1 + trial % 6,
                                  .degreeV = 1 + (trial * 5) % 7,
                                  .spans = 2,
                                  .rational = trial % 3 != 0,
                                  .spanRatio = trial % 4 == 0 ? 1e3 : 4.0,
                                  .clamped = trial % 5 != 0,
                                  .weightRatio = trial % 7 == 0 ? 100.0 : 4.0});
}

TEST(GridChoice, KeepsWhatShowsOfKsQuadsThroughTheNearPlaneWithinTheTolerance)
{
    std::mt19937 random(26);
    Sweep sweep;
    for (int trial = 0; trial < viewsOfEach(60); ++trial) {
        const NurbsSurface surface = anySurface(random, trial);
        const auto quads = ksQuads(surface);
        const KsQuad quad = quads[random() % quads.size()];
        const BezierNet net = BezierConversion(surface).net(quad);
        Box around;  // the eye stands among the KSQuad's own points
        for (const Vec4& point : net.points)
            around.add(Vec3(point) / point.w);
        const RandomView view = randomView(random, around, Vec3(0), true, false);
        measure({transformed(net, view.view.toPixels), view.view}, kTolerances[trial % 4],
                Triangles::eitherDiagonal, sweep);
    }
    sweep.record();
    EXPECT_EQ(sweep.violations, 0);
    EXPECT_GT(sweep.crossingNear, 15);
    EXPECT_LT(static_cast<double>(sweep.notKept), 0.2 * static_cast<double>(sweep.ksQuadViews));
}

TEST(GridChoice, KeepsRandomSurfacesWithinTheTolerance)
{
    std::mt19937 random(22);
    Sweep sweep;
    for (int trial = 0; trial < viewsOfEach(40); ++trial) {
        const Scene scene = sceneOf(anySurface(random, trial));
        const auto quads = ksQuadsOf(scene);
        for (int k = 0; k < 4; ++k) {
            const RandomView view = randomView(random, scene.bounds(), Vec3(0), k % 2 == 1, k == 2);
            const SeenNet seen = seenNet(quads[random() % quads.size()], view);
            measure(seen, kTolerances[(trial + k) % 4],
                    trial % 2 == 0 ? Triangles::eitherDiagonal : Triangles::risingDiagonal, sweep);
        }
    }
    sweep.record();
    EXPECT_EQ(sweep.violations, 0);
    EXPECT_LT(static_cast<double>(sweep.notMeasured + sweep.notKept),
              0.1 * static_cast<double>(sweep.ksQuadViews));
}

TEST(GridChoice, ForAnyTrianglesHoldsForEachThatFitsIntoACell)
{
    std::mt19937 random(23);
    int kept = 0;
    for (int trial = 0; trial < viewsOfEach(30); ++trial) {
        const Scene scene = sceneOf(anySurface(random, trial));
        const auto quads = ksQuadsOf(scene);
        const RandomView view = randomView(random, scene.bounds(), Vec3(0), trial % 3 == 2, false);
        const SeenNet seen = seenNet(quads[random() % quads.size()], view);
        const GridChoice choice = chooseGrid(seen.net, seen.view, 1.0, Triangles::any, 1024);
        if (!choice.kept)
            continue;
        ++kept;
        for (int k = 0; k < 40; ++k) {
            const Vec2 cells(choice.grid.u, choice.grid.v);
            const Vec2 cell(std::floor(randomBetween(random, 0, cells.x)),
                            std::floor(randomBetween(random, 0, cells.y)));
            Vec2 corners[3];
            for (Vec2& corner : corners) {  // on the cell's border, as those that stitch
                corner = {randomBetween(random, 0, 1), randomBetween(random, 0, 1)};
                const auto axis = static_cast<int>(random() % 2);
                corner[axis] = std::round(corner[axis]);
                corner = (cell + corner) / cells;
            }
            EXPECT_LE(measuredError(seen.net, seen.view, corners, 8), kRounding);
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
            const SeenNet seen = seenNet(quads[random() % quads.size()], view);
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
        const Scene scene = sceneOf(anySurface(random, trial));
        const RandomView view = randomView(random, scene.bounds(), Vec3(0), false, false);
        const SeenNet seen = seenNet(ksQuadsOf(scene).front(), view);
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
