// A surface as the GPU holds it: KSQuad records, a table for each span and control points, made in double and
// rounded last: to float for pictures, to float or double for evaluation by itself. Control points are
// relative to the surface's own origin, tables normalised to the span, so that t runs over [0, 1].
#pragma once

#include <span>
#include <vector>

#include "model/geometry/basis_evaluators.h"
#include "model/geometry/ksquad.h"
#include "model/scene/scene_object.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

// Everything of one surface; indices inside it count from its own start.
template <class Real>
struct PatchTable {
    std::vector<gpu::KsQuadRecord> ksquads;  // u outer, v inner, as ksQuads() gives them
    std::vector<Real> spanTables;            // of the evaluator (nurbs_basis.glsl)
};
template <class Real>
[[nodiscard]] PatchTable<Real> makePatchTable(const NurbsSurface& surface, Evaluator evaluator);
extern template PatchTable<float> makePatchTable(const NurbsSurface&, Evaluator);
extern template PatchTable<double> makePatchTable(const NurbsSurface&, Evaluator);

// How a surface's control points become numbers of the GPU.
struct PointFrame {
    Vec3 origin{};        // subtracted in double
    double weight = 1.0;  // a power of two that weights are divided by, so that none overflows
    double extent = 0.0;  // the largest coordinate after the subtraction

    [[nodiscard]] static PointFrame of(const NurbsSurface& surface);
    // Homogeneous, coordinates of at most `largest`.
    [[nodiscard]] Vec4 pack(const ControlPoint& point, double largest) const;
};
template <class Real>
[[nodiscard]] std::vector<glm::vec<4, Real>> packPoints(const PointFrame& frame,
                                                        std::span<const ControlPoint> points);
extern template std::vector<glm::vec<4, float>> packPoints(const PointFrame&, std::span<const ControlPoint>);
extern template std::vector<glm::vec<4, double>> packPoints(const PointFrame&, std::span<const ControlPoint>);

// What does not depend on the view; `firstPoint` is where the net starts in the scene's buffer.
[[nodiscard]] gpu::SurfaceRecord makeSurfaceRecord(const SceneObject& object, const PointFrame& frame,
                                                   std::uint32_t firstPoint);

}  // namespace knotspan
