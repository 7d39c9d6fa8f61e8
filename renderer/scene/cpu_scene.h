// The scene as the shaders have it, in double and on the CPU: a source for the texts of shaders/shared that
// C++ compiles, too. Where only control points moved it tells which KSQuads they shape.
#pragma once

#include "renderer/scene/packed_scene.h"
#include "renderer/scene/shared_edges.h"
#include "shaders/shared/nurbs_surface.glsl"

namespace knotspan {

class CpuScene {
public:
    struct Changes {
        bool all = false;                   // nothing is as it was; the rest says nothing then
        bool borders = false;               // who lies along whom, and whose points are drawn there
        std::vector<std::uint8_t> touched;  // by KSQuad: whether its shape changed; empty: none did

        [[nodiscard]] bool any() const { return all || borders || !touched.empty(); }
    };
    // `residents` and `borders` belong together; both are the same as long as no object is another.
    Changes update(const std::vector<Resident>& residents, const BorderTables& borders, Evaluator evaluator);
    void clear() { *this = {}; }

    [[nodiscard]] const std::vector<Resident>& residents() const { return packed_.residents; }
    [[nodiscard]] std::uint32_t ksquadCount() const
    {
        return static_cast<std::uint32_t>(packed_.tables.ksquads.size());
    }
    // Values and slopes of a span's basis functions, by the evaluator.
    [[nodiscard]] gpu::Basis<double> basis(gpu::uint table, int degree, double t) const
    {
        return basis_(*this, table, degree, t);
    }

    // What the shared texts read.
    [[nodiscard]] const gpu::SurfaceRecord& surface(gpu::uint k) const { return packed_.surfaces[k]; }
    [[nodiscard]] const gpu::KsQuadRecord& ksquad(gpu::uint k) const { return packed_.tables.ksquads[k]; }
    [[nodiscard]] double spanTable(gpu::uint k) const { return packed_.tables.spanTables[k]; }
    [[nodiscard]] const glm::dvec4& controlPoint(gpu::uint k) const { return packed_.points[k]; }
    [[nodiscard]] const gpu::BorderSide& borderSide(gpu::uint k) const { return borders_.sides[k]; }
    [[nodiscard]] gpu::uint borderCorner(gpu::uint k) const { return borders_.corners[k]; }
    [[nodiscard]] const gpu::BorderPiece& borderPiece(gpu::uint k) const { return borders_.pieces[k]; }
    [[nodiscard]] const gpu::BorderUse& borderUse(gpu::uint k) const { return borders_.uses[k]; }

private:
    using BasisFunction = gpu::Basis<double> (*)(const CpuScene&, gpu::uint, int, double);

    void replace(Resident& held, const Resident& wanted, Changes& changes);
    void touch(const Resident& resident, size_t point, Changes& changes) const;

    PackedScene<double> packed_;
    BorderTables borders_;
    Evaluator evaluator_ = Evaluator::automatic;
    BasisFunction basis_ = nullptr;
};

}  // namespace knotspan
