// What the sampling pass does for a KSQuad (shaders/sampling/sampling.comp), by the same text, in C++ and in
// any number type.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "model/analysis/grid_choice.h"
#include "renderer/scene/patch_table.h"
#include "shaders/shared/grid_search.glsl"

namespace knotspan::testing {

template <class Real>
struct ChosenGrid {
    Grid grid;
    bool visible = true;
    Real bound = 0;       // in pixels; beyond the tolerance where the largest factor was not enough
    bool atOnce = false;  // one window said so
};

// A surface as it is packed for the GPU.
template <class Real>
class GridSource {
public:
    explicit GridSource(const NurbsSurface& surface)
        : surface_(surface),
          frame_(PointFrame::of(surface)),
          table_(makePatchTable<Real>(surface, Evaluator::triangular)),
          points_(packPoints<Real>(frame_, surface.controlPoints()))
    {
    }

    [[nodiscard]] Real spanTable(gpu::uint index) const { return table_.spanTables[index]; }
    [[nodiscard]] glm::vec<4, Real> controlPoint(gpu::uint index) const { return points_[index]; }
    [[nodiscard]] const gpu::WindowFigures<Real>& window(gpu::uint index) const { return windows_[index]; }

    [[nodiscard]] const Vec3& origin() const { return frame_.origin; }

    // `view` takes points relative to origin() to pixels; `ksquad` is a number of ksQuads().
    [[nodiscard]] ChosenGrid<Real> choose(size_t ksquad, const ScreenView& view, Real tolerance)
    {
        const gpu::KsQuadPlace place = placeOf(table_.ksquads[ksquad]);
        const gpu::PixelMap<Real> map = mapOf(view);
        const gpu::Stretch<Real> all{0, 1};
        const auto whole = gpu::windowFigures<Real>(*this, place, map, all, all);
        if (!whole.visible)
            return {{1, 1}, false, 0, true};
        gpu::FirstGrid first = gpu::firstGrid<Real>(whole, tolerance);
        if (first.u == 1 && first.v == 1)
            return {{1, 1}, true, gpu::windowBound<Real>(whole, 1, 1), true};
        gpu::uint best = gpu::gridKey(first.u, first.v);
        while (first.level < GRID_LEVELS) {
            for (gpu::uint lane = 0; lane < GRID_LANES; ++lane) {
                windows_[lane].visible = false;
                for (gpu::uint k = 0; k < gpu::windowsOfLane(first); ++k) {
                    const gpu::uint number = lane * gpu::windowsOfLane(first) + k;
                    const auto one =
                        gpu::windowFigures<Real>(*this, place, map, gpu::stretchAlongU<Real>(first, number),
                                                 gpu::stretchAlongV<Real>(first, number));
                    windows_[lane] = gpu::joined<Real>(windows_[lane], gpu::normalised<Real>(one));
                }
            }
            for (gpu::uint lane = 0; lane < GRID_LANES; ++lane)
                best = std::min(best, gpu::bestOfLane<Real>(*this, 0, first, lane, tolerance));
            first = gpu::nextLevel(first, best);
        }
        const bool visible =
            std::any_of(windows_.begin(), windows_.end(), [](const auto& window) { return window.visible; });
        const gpu::uint u = gpu::keyU(best);
        const gpu::uint v = gpu::keyV(best);
        return {{static_cast<int>(u), static_cast<int>(v)},
                visible,
                best == GRID_NONE ? gpu::gridBound<Real>(*this, 0, u, v) : tolerance};
    }

private:
    [[nodiscard]] gpu::KsQuadPlace placeOf(const gpu::KsQuadRecord& record) const
    {
        const int p = surface_.degreeU();
        const int q = surface_.degreeV();
        return {record.firstPoint,
                static_cast<gpu::uint>(surface_.countV()),
                record.spanU - static_cast<gpu::uint>((p + 1) * (p + 1)),
                record.spanV - static_cast<gpu::uint>((q + 1) * (q + 1)),
                p,
                q};
    }

    [[nodiscard]] static gpu::PixelMap<Real> mapOf(const ScreenView& view)
    {
        const auto row = [&](int number) {
            return Vec4(view.toPixels[0][number], view.toPixels[1][number], view.toPixels[2][number],
                        view.toPixels[3][number]);
        };
        const Vec2 middle = 0.5 * (view.low + view.high);
        using Row = glm::vec<4, Real>;
        return {Row(row(0) - middle.x * row(3)), Row(row(1) - middle.y * row(3)), Row(row(2)), Row(row(3)),
                glm::vec<2, Real>(view.high - middle)};
    }

    const NurbsSurface& surface_;
    PointFrame frame_;
    PatchTable<Real> table_;
    std::vector<glm::vec<4, Real>> points_;
    std::array<gpu::WindowFigures<Real>, GRID_LANES> windows_{};
};

}  // namespace knotspan::testing
