// What the sampling pass does for a KSQuad (shaders/sampling/sampling.comp), by the same text, in C++ and in
// any number type.
#pragma once

#include <algorithm>
#include <array>

#include "model/analysis/grid_choice.h"
#include "shaders/shared/grid_search.glsl"
#include "tests/shaders/packed_source.h"

namespace knotspan::testing {

template <class Real>
struct ChosenGrid {
    Grid grid;
    bool visible = true;
    Real bound = 0;       // in pixels; beyond the tolerance where the largest factor was not enough
    bool atOnce = false;  // one window said so
};

template <class Real>
class GridSource : public PackedSource<Real> {
public:
    using PackedSource<Real>::PackedSource;

    [[nodiscard]] const gpu::WindowFigures<Real>& window(gpu::uint index) const { return windows_[index]; }

    // `view` takes points relative to origin() to pixels; `ksquad` is a number of ksQuads().
    [[nodiscard]] ChosenGrid<Real> choose(size_t ksquad, const ScreenView& view, Real tolerance)
    {
        const gpu::KsQuadPlace place = placeOf(this->ksquad(static_cast<gpu::uint>(ksquad)));
        const gpu::PixelMap<Real> map = this->mapOf(view);
        const gpu::Stretch<Real> all{0, 1};
        const auto whole = gpu::windowFigures<Real>(*this, place, map, all, all);
        if (!whole.visible)
            return {{1, 1}, false, 0, true};
        gpu::FirstGrid first = gpu::firstGrid<Real>(whole, tolerance);
        if (first.level == GRID_LEVELS)
            return {{static_cast<int>(first.u), static_cast<int>(first.v)},
                    true,
                    gpu::windowBound<Real>(whole, Real(1) / Real(first.u), Real(1) / Real(first.v)),
                    true};
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
        const gpu::SurfaceRecord surface = this->surface(record.surface);
        const gpu::uint p = surface.degreeU;
        const gpu::uint q = surface.degreeV;
        return {record.firstPoint,
                surface.stride,
                record.spanU - (p + 1) * (p + 1),
                record.spanV - (q + 1) * (q + 1),
                static_cast<int>(p),
                static_cast<int>(q)};
    }

    std::array<gpu::WindowFigures<Real>, GRID_LANES> windows_{};
};

}  // namespace knotspan::testing
