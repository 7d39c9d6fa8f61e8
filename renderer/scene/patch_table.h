// A surface as the GPU holds it: KSQuad records, a table for each span and control points, made in double and
// rounded last: to float for pictures, to float or double for evaluation by itself. Control points are
// relative to the surface's own origin, tables normalised to the span, so that t runs over [0, 1].
#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include <glm/common.hpp>

#include "model/geometry/basis_evaluators.h"
#include "model/geometry/ksquad.h"
#include "model/scene/scene_object.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

// Whether a surface has one normal on both sides of the knot line that a span starts with, and the span
// before it as many digits of it.
[[nodiscard]] bool startsSmoothly(const KnotVector& knots, int span);

// The numbers of spans, each kept once however many spans of however many surfaces have the same. A record's
// spanU is where the table of its span starts (nurbs_basis.glsl); the (degree + 1)^2 numbers before it are
// the span's Bezier matrix (bezierMatrix), from which the sampling pass makes nets (grid_choice.glsl); before
// that is 1 where the span starts smoothly, else 0 (edges.glsl).
template <class Real>
class SpanTablePool {
public:
    // Where the table of the span starts.
    [[nodiscard]] std::uint32_t startOf(const KnotVector& knots, int span, Evaluator evaluator)
    {
        return startOf(knots, span, evaluator, startsSmoothly(knots, span));
    }
    // Of a span that stands for another one, which starts so.
    [[nodiscard]] std::uint32_t startOf(const KnotVector& knots, int span, Evaluator evaluator,
                                        bool smoothStart);
    [[nodiscard]] const std::vector<Real>& numbers() const { return numbers_; }
    [[nodiscard]] std::vector<Real> takeNumbers() { return std::move(numbers_); }

private:
    std::vector<Real> numbers_;
    std::map<std::vector<Real>, std::uint32_t> starts_;
};
extern template class SpanTablePool<float>;
extern template class SpanTablePool<double>;

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

// The KSQuad records alone, with tables in a pool of many surfaces.
template <class Real>
[[nodiscard]] std::vector<gpu::KsQuadRecord>
makeKsQuadRecords(const NurbsSurface& surface, Evaluator evaluator, SpanTablePool<Real>& pool);
extern template std::vector<gpu::KsQuadRecord> makeKsQuadRecords(const NurbsSurface&, Evaluator,
                                                                 SpanTablePool<float>&);
extern template std::vector<gpu::KsQuadRecord> makeKsQuadRecords(const NurbsSurface&, Evaluator,
                                                                 SpanTablePool<double>&);

// How a surface's control points become numbers of the GPU.
struct PointFrame {
    Vec3 origin{};        // subtracted in double
    double weight = 1.0;  // a power of two that weights are divided by, so that none overflows
    double extent = 0.0;  // the largest coordinate after the subtraction

    [[nodiscard]] static PointFrame of(const NurbsSurface& surface);
    // Homogeneous, coordinates of at most `largest`.
    [[nodiscard]] Vec4 pack(const ControlPoint& point, double largest) const
    {
        // Not zero: a point of no weight that shapes a KSQuad alone would be nowhere.
        const double scaled = std::max(point.weight / weight, 1e-30);
        return {glm::clamp(point.position - origin, -largest, largest) * scaled, scaled};
    }
};
template <class Real>
[[nodiscard]] std::vector<glm::vec<4, Real>> packPoints(const PointFrame& frame,
                                                        std::span<const ControlPoint> points);
extern template std::vector<glm::vec<4, float>> packPoints(const PointFrame&, std::span<const ControlPoint>);
extern template std::vector<glm::vec<4, double>> packPoints(const PointFrame&, std::span<const ControlPoint>);

// As light adds up, from sRGB.
[[nodiscard]] gpu::vec3 linearColour(const Colour& colour);

// What does not depend on the view; `firstPoint` is where the net starts in the scene's buffer. Where its
// KSQuads and borders start is left at 0.
[[nodiscard]] gpu::SurfaceRecord makeSurfaceRecord(const SceneObject& object, const PointFrame& frame,
                                                   std::uint32_t firstPoint);

}  // namespace knotspan
