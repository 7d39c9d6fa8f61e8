// A surface as it is packed for the GPU, for the texts that shaders and C++ share.
#pragma once

#include <vector>

#include "model/analysis/screen_error.h"
#include "renderer/scene/patch_table.h"
#include "shaders/shared/pixel_map.glsl"

namespace knotspan::testing {

template <class Real>
class PackedSource {
public:
    explicit PackedSource(const NurbsSurface& surface)
        : surface_(surface),
          frame_(PointFrame::of(surface)),
          table_(makePatchTable<Real>(surface, Evaluator::triangular)),
          points_(packPoints<Real>(frame_, surface.controlPoints()))
    {
    }

    [[nodiscard]] Real spanTable(gpu::uint index) const { return table_.spanTables[index]; }
    [[nodiscard]] glm::vec<4, Real> controlPoint(gpu::uint index) const { return points_[index]; }
    [[nodiscard]] const gpu::KsQuadRecord& ksquad(gpu::uint index) const { return table_.ksquads[index]; }
    [[nodiscard]] gpu::SurfaceRecord surface(gpu::uint) const
    {
        gpu::SurfaceRecord record{};
        record.degreeU = static_cast<gpu::uint>(surface_.degreeU());
        record.degreeV = static_cast<gpu::uint>(surface_.degreeV());
        record.stride = static_cast<gpu::uint>(surface_.countV());
        return record;
    }

    // Points are given to it relative to this.
    [[nodiscard]] const Vec3& origin() const { return frame_.origin; }
    [[nodiscard]] size_t ksquadCount() const { return table_.ksquads.size(); }

protected:
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

private:
    const NurbsSurface& surface_;
    PointFrame frame_;
    PatchTable<Real> table_;
    std::vector<glm::vec<4, Real>> points_;
};

}  // namespace knotspan::testing
