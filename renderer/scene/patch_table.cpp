#include "renderer/scene/patch_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "model/geometry/bezier_conversion.h"
#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

template <class Real>
std::vector<std::uint32_t> startsOf(const KnotVector& knots, Evaluator evaluator, SpanTablePool<Real>& pool)
{
    std::vector<std::uint32_t> starts;
    for (const int span : knots.spans())
        starts.push_back(pool.startOf(knots, span, evaluator));
    return starts;
}

float linear(double encoded)
{
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

// Whether curves of these knots end in a control point, there or at their start.
bool isClamped(const KnotVector& knots, bool atEnd)
{
    const int last = static_cast<int>(knots.values().size()) - 1;
    return atEnd ? knots[last - 1] == knots.domainEnd() : knots[1] == knots.domainStart();
}

Vec3 cornerOf(const NurbsSurface& surface, bool endU, bool endV)
{
    const KnotVector& u = surface.knotsU();
    const KnotVector& v = surface.knotsV();
    // The same, and every frame of a deforming model asks.
    if (isClamped(u, endU) && isClamped(v, endV))
        return surface.controlPoint(endU ? surface.countU() - 1 : 0, endV ? surface.countV() - 1 : 0)
            .position;
    return evaluate(surface, endU ? u.domainEnd() : u.domainStart(), endV ? v.domainEnd() : v.domainStart())
        .position;
}

}  // namespace

// Of control points nothing is asked: where some coincide tangents may vanish, on both sides alike. A span
// before it that is much shorter has shorter tangents, of which float leaves fewer digits: culling counts on
// as good a normal as the KSQuad's own (facing_forms.glsl).
bool startsSmoothly(const KnotVector& knots, int span)
{
    const double start = knots[span];
    int before = span;
    while (before >= 0 && knots[before] == start)
        --before;
    return before >= 0 && start > knots.domainStart() && span - before < knots.degree() &&
           start - knots[before] >= 0.5 * (knots[span + 1] - start);
}

template <class Real>
std::uint32_t SpanTablePool<Real>::startOf(const KnotVector& knots, int span, Evaluator evaluator,
                                           bool smoothStart)
{
    std::vector<Real> wanted{static_cast<Real>(smoothStart ? 1 : 0)};
    for (const double share : bezierMatrix(knots, span))
        wanted.push_back(static_cast<Real>(share));
    const auto before = static_cast<std::uint32_t>(wanted.size());
    appendSpanTable(evaluator, knots, span, wanted);
    const auto start = static_cast<std::uint32_t>(numbers_.size());
    const auto [entry, isNew] = starts_.try_emplace(std::move(wanted), start + before);
    if (isNew)
        numbers_.insert(numbers_.end(), entry->first.begin(), entry->first.end());
    return entry->second;
}

template class SpanTablePool<float>;
template class SpanTablePool<double>;

template <class Real>
std::vector<gpu::KsQuadRecord> makeKsQuadRecords(const NurbsSurface& surface, Evaluator evaluator,
                                                 SpanTablePool<Real>& pool)
{
    std::vector<gpu::KsQuadRecord> records;
    const auto startsU = startsOf(surface.knotsU(), evaluator, pool);
    const auto startsV = startsOf(surface.knotsV(), evaluator, pool);
    records.reserve(startsU.size() * startsV.size());
    for (size_t a = 0; a < startsU.size(); ++a)
        for (size_t b = 0; b < startsV.size(); ++b) {
            const int i = surface.knotsU().spans()[a] - surface.degreeU();
            const int j = surface.knotsV().spans()[b] - surface.degreeV();
            records.push_back(
                {0, static_cast<std::uint32_t>(i * surface.countV() + j), startsU[a], startsV[b]});
        }
    return records;
}

template std::vector<gpu::KsQuadRecord> makeKsQuadRecords(const NurbsSurface&, Evaluator,
                                                          SpanTablePool<float>&);
template std::vector<gpu::KsQuadRecord> makeKsQuadRecords(const NurbsSurface&, Evaluator,
                                                          SpanTablePool<double>&);

template <class Real>
PatchTable<Real> makePatchTable(const NurbsSurface& surface, Evaluator evaluator)
{
    SpanTablePool<Real> pool;
    PatchTable<Real> table;
    table.ksquads = makeKsQuadRecords(surface, evaluator, pool);
    table.spanTables = pool.takeNumbers();
    return table;
}

template PatchTable<float> makePatchTable(const NurbsSurface&, Evaluator);
template PatchTable<double> makePatchTable(const NurbsSurface&, Evaluator);

PointFrame PointFrame::of(const NurbsSurface& surface)
{
    PointFrame frame;
    frame.origin = surface.bounds().centre();
    double heaviest = 0.0;
    for (const ControlPoint& point : surface.controlPoints()) {
        const Vec3 offset = glm::abs(point.position - frame.origin);
        frame.extent = std::max({frame.extent, offset.x, offset.y, offset.z});
        heaviest = std::max(heaviest, point.weight);
    }
    frame.weight = std::exp2(std::floor(std::log2(heaviest)));
    return frame;
}

template <class Real>
std::vector<glm::vec<4, Real>> packPoints(const PointFrame& frame, std::span<const ControlPoint> points)
{
    // Sums and quotients of numbers below this stay finite; a surface beyond it is drawn, not rightly, but as
    // numbers.
    constexpr double kLargest = std::numeric_limits<Real>::max() / 1e8;
    std::vector<glm::vec<4, Real>> packed(points.size());
    std::transform(points.begin(), points.end(), packed.begin(),
                   [&](const ControlPoint& point) { return glm::vec<4, Real>(frame.pack(point, kLargest)); });
    return packed;
}

template std::vector<glm::vec<4, float>> packPoints(const PointFrame&, std::span<const ControlPoint>);
template std::vector<glm::vec<4, double>> packPoints(const PointFrame&, std::span<const ControlPoint>);

gpu::vec3 linearColour(const Colour& colour)
{
    return {linear(colour.red), linear(colour.green), linear(colour.blue)};
}

gpu::SurfaceRecord makeSurfaceRecord(const SceneObject& object, const PointFrame& frame,
                                     std::uint32_t firstPoint)
{
    const NurbsSurface& surface = object.surface;
    gpu::SurfaceRecord record{};
    record.degreeU = static_cast<std::uint32_t>(surface.degreeU());
    record.degreeV = static_cast<std::uint32_t>(surface.degreeV());
    record.stride = static_cast<std::uint32_t>(surface.countV());
    record.firstPoint = firstPoint;
    for (int corner = 0; corner < 4; ++corner)
        record.corners[corner] =
            gpu::vec3(cornerOf(surface, (corner & 1) != 0, (corner & 2) != 0) - frame.origin);
    record.spansU = static_cast<std::uint32_t>(surface.knotsU().spans().size());
    record.spansV = static_cast<std::uint32_t>(surface.knotsV().spans().size());
    record.colour = linearColour(object.colour);
    return record;
}

}  // namespace knotspan
