// Vertices of KSQuads' drawn grids, made on the CPU in double as vertexOf() of shaders/shared/scene.glsl
// makes them. A vertex is a function of its GridVertex alone: whoever draws a point of an edge gets the same
// bits.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/scene/cpu_scene.h"
#include "shaders/shared/borders.glsl"

namespace knotspan {

// What borders.glsl reads: the scene, and what each KSQuad asks for.
class AskedGrids {
public:
    AskedGrids(const CpuScene& scene, const std::vector<gpu::GridRecord>& grids)
        : scene_(scene),
          grids_(grids)
    {
    }

    [[nodiscard]] const gpu::GridRecord& grid(gpu::uint k) const { return grids_[k]; }
    [[nodiscard]] const gpu::SurfaceRecord& surface(gpu::uint k) const { return scene_.surface(k); }
    [[nodiscard]] const gpu::KsQuadRecord& ksquad(gpu::uint k) const { return scene_.ksquad(k); }
    [[nodiscard]] const gpu::BorderSide& borderSide(gpu::uint k) const { return scene_.borderSide(k); }
    [[nodiscard]] gpu::uint borderCorner(gpu::uint k) const { return scene_.borderCorner(k); }
    [[nodiscard]] const gpu::BorderPiece& borderPiece(gpu::uint k) const { return scene_.borderPiece(k); }
    [[nodiscard]] const gpu::BorderUse& borderUse(gpu::uint k) const { return scene_.borderUse(k); }
    [[nodiscard]] double spanTable(gpu::uint k) const { return scene_.spanTable(k); }

private:
    const CpuScene& scene_;
    const std::vector<gpu::GridRecord>& grids_;
};

// All (u + 1) (v + 1) of a KSQuad's grid.
void makeVertices(const CpuScene& scene, const AskedGrids& asked, std::uint32_t ksquad,
                  const gpu::DrawnGrid& grid, gpu::ObjectVertex* vertices);

// Of vertices already made: `all` of the grid's border, or those whose point is now another one or one of a
// KSQuad that is `touched` (empty: none is). Returns how many were made.
std::uint32_t renewBorder(const CpuScene& scene, const AskedGrids& asked,
                          const std::vector<std::uint8_t>& touched, bool all, std::uint32_t ksquad,
                          const gpu::DrawnGrid& grid, gpu::ObjectVertex* vertices);

}  // namespace knotspan
