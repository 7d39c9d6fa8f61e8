// A surface as the GPU holds it: KSQuad records, knots packed per span and control points, made in double and
// turned to float last (design: control points relative to the surface's own origin, knots as differences
// normalised to the span, t in [0, 1]).
#pragma once

#include <span>
#include <vector>

#include "model/geometry/ksquad.h"
#include "model/scene/scene_object.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

// Everything of one surface; indices inside it count from its own start.
struct PatchTable {
    std::vector<gpu::KsQuadRecord> ksquads;  // u outer, v inner, as ksQuads() gives them
    std::vector<float> spanKnots;            // nurbs_basis.glsl
};
[[nodiscard]] PatchTable makePatchTable(const NurbsSurface& surface);

// 2p numbers for span i of degree p, normalised to the span's length (nurbs_basis.glsl).
void appendSpanKnots(const KnotVector& knots, int span, std::vector<float>& to);

// How a surface's control points become floats.
struct PointFrame {
    Vec3 origin{};        // subtracted in double
    double weight = 1.0;  // a power of two that weights are divided by, so that none overflows
    double extent = 0.0;  // the largest coordinate after the subtraction

    [[nodiscard]] static PointFrame of(const NurbsSurface& surface);
    [[nodiscard]] gpu::vec4 pack(const ControlPoint& point) const;
};
[[nodiscard]] std::vector<gpu::vec4> packPoints(const PointFrame& frame,
                                                std::span<const ControlPoint> points);

// What does not depend on the view; `firstPoint` is where the net starts in the scene's buffer.
[[nodiscard]] gpu::SurfaceRecord makeSurfaceRecord(const SceneObject& object, const PointFrame& frame,
                                                   std::uint32_t firstPoint);

}  // namespace knotspan
