#include "renderer/scene/adaptive_grids.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>

#include <glm/matrix.hpp>
#include <tbb/parallel_for.h>

#include "renderer/scene/cpu_culling.h"
#include "renderer/scene/cpu_vertices.h"
#include "renderer/scene/surface_views.h"
#include "shaders/shared/asking.glsl"
#include "shaders/shared/grid_search.glsl"

namespace knotspan {

namespace {

gpu::PixelMap<double> pixelMap(const Resident& resident, const Camera& camera, const Mat4& projection,
                               const Vec2& middle)
{
    const Mat4& transform = resident.object->transform;
    const Mat4 rotation = camera.rotation();
    Mat4 toView = rotation * transform;
    toView[3] = rotation * Vec4(transformed(resident.frame.origin, transform) - camera.eye, 1.0);
    const Mat4 rows = glm::transpose(projection * toView);
    return {middle.x * rows[0], middle.y * rows[1], rows[2], rows[3], middle};
}

bool isSame(const gpu::PixelMap<double>& a, const gpu::PixelMap<double>& b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w && a.middle == b.middle;
}

bool isSame(const gpu::SurfaceView& a, const gpu::SurfaceView& b)
{
    return a.modelView == b.modelView && a.eye == b.eye;
}

bool isSame(const gpu::DrawnGrid& a, const gpu::DrawnGrid& b)
{
    return a.u == b.u && a.v == b.v && std::equal(a.edges, a.edges + 4, b.edges) && a.divided == b.divided;
}

gpu::KsQuadPlace placeOfNumbers(const CpuScene& scene, const gpu::KsQuadRecord& ksquad)
{
    const gpu::SurfaceRecord& surface = scene.surface(ksquad.surface);
    const auto matrixSize = [](gpu::uint degree) { return (degree + 1) * (degree + 1); };
    gpu::KsQuadPlace place{};
    place.degreeU = static_cast<int>(surface.degreeU);
    place.degreeV = static_cast<int>(surface.degreeV);
    place.firstPoint = ksquad.firstPoint;
    place.stride = surface.stride;
    place.tableU = ksquad.spanU - matrixSize(surface.degreeU);
    place.tableV = ksquad.spanV - matrixSize(surface.degreeV);
    return place;
}

// What asking.glsl reads beside.
struct AskingSource : AskedGrids {
    AskingSource(const CpuScene& scene, const std::vector<gpu::GridRecord>& grids,
                 const std::vector<std::int8_t>& culledBy)
        : AskedGrids(scene, grids),
          culled(culledBy)
    {
    }
    [[nodiscard]] bool isVisible(gpu::uint k) const { return culled[k] == kNotCulled; }
    const std::vector<std::int8_t>& culled;
};

gpu::PixelMap<float> inFloat(const gpu::PixelMap<double>& map)
{
    return {gpu::vec4(map.x), gpu::vec4(map.y), gpu::vec4(map.z), gpu::vec4(map.w), gpu::vec2(map.middle)};
}

// One KSQuad's windows beside the scene's numbers: what the texts of the choice read.
struct Windows {
    const CpuScene& scene;
    std::array<gpu::WindowFigures<double>, GRID_LANES> figures{};

    [[nodiscard]] double spanTable(gpu::uint k) const { return scene.spanTable(k); }
    [[nodiscard]] const glm::dvec4& controlPoint(gpu::uint k) const { return scene.controlPoint(k); }
    [[nodiscard]] const gpu::WindowFigures<double>& window(gpu::uint k) const { return figures[k]; }
};

struct Choice {
    gpu::GridRecord grid{};  // of 0 cells: nothing of it shows
    double bound = 0;
};

gpu::GridRecord evenGrid(gpu::uint u, gpu::uint v)
{
    return gpu::gridRecord(v, v, u, u);
}

// The figures of all windows of a lane.
gpu::WindowFigures<double> figuresOfLane(const Windows& windows, const gpu::KsQuadPlace& place,
                                         const gpu::PixelMap<double>& map, const gpu::FirstGrid& first,
                                         gpu::uint lane)
{
    gpu::WindowFigures<double> sum{};
    for (gpu::uint k = 0; k < gpu::windowsOfLane(first); ++k) {
        const gpu::uint number = lane * gpu::windowsOfLane(first) + k;
        const auto one =
            gpu::windowFigures<double>(windows, place, map, gpu::stretchAlongU<double>(first, number),
                                       gpu::stretchAlongV<double>(first, number));
        sum = gpu::joined<double>(sum, gpu::normalised<double>(one));
    }
    return sum;
}

// What sampling.comp does for a KSQuad.
Choice chooseGrid(const CpuScene& scene, std::uint32_t ksquad, const gpu::PixelMap<double>& map,
                  double tolerance)
{
    Windows windows{scene};
    const gpu::KsQuadPlace place = placeOfNumbers(scene, scene.ksquad(ksquad));
    const gpu::Stretch<double> whole{0, 1};
    const auto figures = gpu::windowFigures<double>(windows, place, map, whole, whole);
    if (!figures.visible)
        return {};
    gpu::FirstGrid first = gpu::firstGrid<double>(figures, tolerance);
    if (first.level == GRID_LEVELS)
        return {evenGrid(first.u, first.v), gpu::windowBound<double>(figures, 1.0 / first.u, 1.0 / first.v)};
    gpu::uint best = gpu::gridKey(first.u, first.v);
    while (first.level < GRID_LEVELS) {
        bool shows = false;
        for (gpu::uint lane = 0; lane < GRID_LANES; ++lane) {
            windows.figures[lane] = figuresOfLane(windows, place, map, first, lane);
            shows = shows || windows.figures[lane].visible;
        }
        if (!shows)
            return {};
        for (gpu::uint lane = 0; lane < GRID_LANES; ++lane)
            best = std::min(best, gpu::bestOfLane<double>(windows, 0, first, lane, tolerance));
        first = gpu::nextLevel(first, best);
    }
    // Where nothing was fine enough, no bound is known.
    return {evenGrid(gpu::keyU(best), gpu::keyV(best)), best == GRID_NONE ? double{GRID_HUGE} : tolerance};
}

}  // namespace

GridView GridView::of(const std::vector<Resident>& residents, const Camera& camera, double width,
                      double height, const Box& bounds, double tolerancePx, std::uint32_t cullBits,
                      const SideTables& sides)
{
    GridView view;
    view.tolerancePx = tolerancePx;
    view.cullBits = cullBits;
    const Mat4 projection = camera.projection(width / height, bounds);
    for (size_t k = 0; k < residents.size(); ++k) {
        view.maps.push_back(pixelMap(residents[k], camera, projection, {0.5 * width, 0.5 * height}));
        view.views.push_back(surfaceView(residents[k], camera, sides.sides[k], sides.shells[k]));
        view.sides.push_back(sides.shownSide(k));
    }
    return view;
}

bool AdaptiveGrids::seesAnew(const GridView& view) const
{
    return view.tolerancePx != view_.tolerancePx || view.cullBits != view_.cullBits ||
           view.sides != view_.sides || view.kept != view_.kept ||
           !std::equal(view.views.begin(), view.views.end(), view_.views.begin(), view_.views.end(),
                       [](const auto& a, const auto& b) { return isSame(a, b); }) ||
           !std::equal(view.maps.begin(), view.maps.end(), view_.maps.begin(), view_.maps.end(),
                       [](const auto& a, const auto& b) { return isSame(a, b); });
}

AdaptiveGrids::Work AdaptiveGrids::update(const CpuScene& scene, const CpuScene::Changes& changes,
                                          const GridView& view)
{
    Work work;
    if (changes.all || grids_.size() != scene.ksquadCount()) {
        clear();
        asked_.resize(scene.ksquadCount());
        bounds_.resize(scene.ksquadCount());
        culledBy_.resize(scene.ksquadCount());
        hasChosen_.resize(scene.ksquadCount());
        drawn_.resize(scene.ksquadCount());
        grids_.resize(scene.ksquadCount());
        stale_.resize(scene.ksquadCount());
    } else if (!changes.any() && !seesAnew(view)) {
        return work;
    }
    work.chosen = choose(scene, changes, view);
    drawAll(scene, changes);
    work.built = static_cast<std::uint32_t>(std::count(stale_.begin(), stale_.end(), 1));
    work.evaluations = makeAll(scene, changes);
    return work;
}

std::uint32_t AdaptiveGrids::choose(const CpuScene& scene, const CpuScene::Changes& changes,
                                    const GridView& view)
{
    // A surface may be dropped for corners that its other KSQuads do not see.
    const bool all = seesAnew(view) || (view.cullBits != 0 && changes.any());
    view_ = view;
    std::vector<CullView> cullViews;
    for (size_t k = 0; k < view.maps.size(); ++k)
        cullViews.push_back({inFloat(view.maps[k]), view.views[k], view.sides[k], view.facing});
    std::vector<std::uint8_t> changed(changes.touched);
    changed.resize(scene.ksquadCount(), 0);
    if (all)
        std::fill(changed.begin(), changed.end(), std::uint8_t{1});
    tbb::parallel_for(std::uint32_t{0}, scene.ksquadCount(), [&](std::uint32_t k) {
        if (changed[k] != 0)
            culledBy_[k] = view.kept != nullptr
                               ? (*view.kept)[k]
                               : static_cast<std::int8_t>(knotspan::culledBy(
                                     scene, k, cullViews[scene.ksquad(k).surface], view.cullBits));
    });
    const auto wanted = thoseToChooseFor(scene, changed);
    tbb::parallel_for(size_t{0}, wanted.size(), [&](size_t index) {
        const std::uint32_t k = wanted[index];
        const Choice choice = chooseGrid(scene, k, view.maps[scene.ksquad(k).surface], view.tolerancePx);
        asked_[k] = choice.grid;
        bounds_[k] = static_cast<float>(choice.bound);
    });
    return static_cast<std::uint32_t>(wanted.size());
}

// Those that are drawn and their neighbours, where they have changed or were not asked before.
std::vector<std::uint32_t> AdaptiveGrids::thoseToChooseFor(const CpuScene& scene,
                                                           const std::vector<std::uint8_t>& changed)
{
    const AskingSource source(scene, asked_, culledBy_);
    std::vector<std::uint32_t> wanted;
    for (std::uint32_t k = 0; k < scene.ksquadCount(); ++k) {
        const bool asks = gpu::asks(source, k);
        if (asks && (changed[k] != 0 || hasChosen_[k] == 0))
            wanted.push_back(k);
        hasChosen_[k] = asks ? 1 : 0;
        if (!asks)
            asked_[k] = {};
    }
    return wanted;
}

void AdaptiveGrids::drawAll(const CpuScene& scene, const CpuScene::Changes& changes)
{
    const AskedGrids asked(scene, asked_);
    std::vector<gpu::DrawnGrid> drawn(scene.ksquadCount());
    tbb::parallel_for(std::uint32_t{0}, scene.ksquadCount(), [&](std::uint32_t k) {
        if (asked_[k].alongU != 0 && culledBy_[k] == kNotCulled)
            drawn[k] = gpu::drawnGrid(asked, k, SNAP_FALLING);
    });
    for (std::uint32_t k = 0; k < scene.ksquadCount(); ++k) {
        const bool touched = !changes.touched.empty() && changes.touched[k] != 0;
        stale_[k] = drawn[k].u > 0 && (touched || !isSame(drawn[k], drawn_[k])) ? 1 : 0;
        if (drawn[k].u != grids_[k].u || drawn[k].v != grids_[k].v)
            store_.place(grids_[k], drawn[k].u, drawn[k].v);
    }
    drawn_ = std::move(drawn);
    store_.compact(grids_);
}

std::uint64_t AdaptiveGrids::makeAll(const CpuScene& scene, const CpuScene::Changes& changes)
{
    const AskedGrids asked(scene, asked_);
    std::vector<std::uint32_t> made(scene.ksquadCount());
    tbb::parallel_for(std::uint32_t{0}, scene.ksquadCount(), [&](std::uint32_t k) {
        if (grids_[k].u == 0)
            return;
        if (stale_[k] != 0) {
            makeVertices(scene, asked, k, drawn_[k], store_.at(grids_[k]));
            made[k] = grids_[k].vertexCount();
        } else if (changes.borders || !changes.touched.empty() || drawn_[k].divided != 0) {
            made[k] = renewBorder(scene, asked, changes.touched, changes.borders, k, drawn_[k],
                                  store_.at(grids_[k]));
        }
    });
    for (std::uint32_t k = 0; k < scene.ksquadCount(); ++k)
        if (made[k] > 0)
            store_.changed(grids_[k]);
    return std::accumulate(made.begin(), made.end(), std::uint64_t{0});
}

double AdaptiveGrids::bound() const
{
    double largest = 0;
    for (size_t k = 0; k < grids_.size(); ++k)
        if (grids_[k].u > 0)
            largest = std::max(largest, double{bounds_[k]});
    return largest;
}

std::array<std::uint32_t, KNOTSPAN_CULL_MODE_COUNT> AdaptiveGrids::culled() const
{
    std::array<std::uint32_t, KNOTSPAN_CULL_MODE_COUNT> counts{};
    for (const int mode : culledBy_)
        if (mode != kNotCulled)
            ++counts[static_cast<size_t>(mode)];
    return counts;
}

}  // namespace knotspan
