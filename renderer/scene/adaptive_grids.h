// The KSQuads' grids by the bound (shaders/shared/grid_choice.glsl), chosen and evaluated on the CPU: what
// the sampling pass and a vertex stage do, but only for what is no longer as it was.
#pragma once

#include <array>

#include "renderer/scene/camera.h"
#include "renderer/scene/cpu_scene.h"
#include "renderer/scene/facing_arrays.h"
#include "renderer/scene/shown_sides.h"
#include "renderer/scene/vertex_store.h"
#include "shaders/shared/borders.glsl"
#include "shaders/shared/cull_list.h"
#include "shaders/shared/grid_choice.glsl"

namespace knotspan {

// A picture that grids are chosen for.
struct GridView {
    std::vector<gpu::PixelMap<double>> maps;  // by surface
    std::vector<gpu::SurfaceView> views;      // by surface
    std::vector<float> sides;                 // that are shown alone, likewise
    double tolerancePx = 0;
    std::uint32_t cullBits = 0;
    const FacingArrays* facing = nullptr;  // of the scene, where a culling mode reads it
    // By KSQuad, as AdaptiveGrids::culledBy(): of a culling camera that stands still. Then no mode is asked.
    const std::vector<std::int8_t>* kept = nullptr;

    // `bounds` sets the depth range, as in Camera::projection(); and `sides` say which are shown.
    [[nodiscard]] static GridView of(const std::vector<Resident>& residents, const Camera& camera,
                                     double width, double height, const Box& bounds, double tolerancePx,
                                     std::uint32_t cullBits, const SideTables& sides);
};

class AdaptiveGrids {
public:
    struct Work {
        std::uint32_t chosen = 0;       // KSQuads whose grid was asked for anew
        std::uint32_t built = 0;        // whose vertices were all made
        std::uint64_t evaluations = 0;  // vertices
    };
    // `changes` are those of the scene since the last update.
    Work update(const CpuScene& scene, const CpuScene::Changes& changes, const GridView& view);
    void clear() { *this = {}; }

    // By KSQuad; those that do not show have none. Cells are to be cut from (1, 0) to (0, 1).
    [[nodiscard]] const std::vector<VertexGrid>& grids() const { return grids_; }
    [[nodiscard]] VertexStore& store() { return store_; }
    [[nodiscard]] const VertexStore& store() const { return store_; }
    void closeGaps() { store_.compact(grids_, true); }
    // In pixels, the largest of all.
    [[nodiscard]] double bound() const;
    // By KSQuad: the culling mode that dropped it, or kNotCulled.
    [[nodiscard]] const std::vector<std::int8_t>& culledBy() const { return culledBy_; }
    // KSQuads that each culling mode dropped.
    [[nodiscard]] std::array<std::uint32_t, KNOTSPAN_CULL_MODE_COUNT> culled() const;

private:
    [[nodiscard]] bool seesAnew(const GridView& view) const;
    [[nodiscard]] std::uint32_t choose(const CpuScene& scene, const CpuScene::Changes& changes,
                                       const GridView& view);
    [[nodiscard]] std::vector<std::uint32_t> thoseToChooseFor(const CpuScene& scene,
                                                              const std::vector<std::uint8_t>& changed);
    void drawAll(const CpuScene& scene, const CpuScene::Changes& changes);
    [[nodiscard]] std::uint64_t makeAll(const CpuScene& scene, const CpuScene::Changes& changes);

    GridView view_;
    std::vector<gpu::GridRecord> asked_;
    std::vector<float> bounds_;
    std::vector<std::int8_t> culledBy_;
    std::vector<std::uint8_t> hasChosen_;  // asked_ is of this view
    std::vector<gpu::DrawnGrid> drawn_;
    std::vector<VertexGrid> grids_;
    std::vector<std::uint8_t> stale_;  // vertices are to be made
    VertexStore store_;
};

}  // namespace knotspan
