#include "renderer/scene/patch_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <glm/common.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

// Where the table of each span of a direction starts, in the order of KnotVector::spans().
template <class Real>
std::vector<std::uint32_t> packDirection(const KnotVector& knots, Evaluator evaluator, std::vector<Real>& to)
{
    std::vector<std::uint32_t> starts;
    for (const int span : knots.spans()) {
        starts.push_back(static_cast<std::uint32_t>(to.size()));
        appendSpanTable(evaluator, knots, span, to);
    }
    return starts;
}

float linear(double encoded)
{
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

}  // namespace

template <class Real>
PatchTable<Real> makePatchTable(const NurbsSurface& surface, Evaluator evaluator)
{
    PatchTable<Real> table;
    const auto startsU = packDirection(surface.knotsU(), evaluator, table.spanTables);
    const auto startsV = packDirection(surface.knotsV(), evaluator, table.spanTables);
    table.ksquads.reserve(startsU.size() * startsV.size());
    for (size_t a = 0; a < startsU.size(); ++a)
        for (size_t b = 0; b < startsV.size(); ++b) {
            const int i = surface.knotsU().spans()[a] - surface.degreeU();
            const int j = surface.knotsV().spans()[b] - surface.degreeV();
            table.ksquads.push_back(
                {0, static_cast<std::uint32_t>(i * surface.countV() + j), startsU[a], startsV[b]});
        }
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

Vec4 PointFrame::pack(const ControlPoint& point, double largest) const
{
    // Not zero: a point of no weight that shapes a KSQuad alone would be nowhere.
    const double scaled = std::max(point.weight / weight, 1e-30);
    return {glm::clamp(point.position - origin, -largest, largest) * scaled, scaled};
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

gpu::SurfaceRecord makeSurfaceRecord(const SceneObject& object, const PointFrame& frame,
                                     std::uint32_t firstPoint)
{
    const NurbsSurface& surface = object.surface;
    gpu::SurfaceRecord record{};
    record.degreeU = static_cast<std::uint32_t>(surface.degreeU());
    record.degreeV = static_cast<std::uint32_t>(surface.degreeV());
    record.stride = static_cast<std::uint32_t>(surface.countV());
    record.firstPoint = firstPoint;
    for (int corner = 0; corner < 4; ++corner) {
        const double u = (corner & 1) != 0 ? surface.knotsU().domainEnd() : surface.knotsU().domainStart();
        const double v = (corner & 2) != 0 ? surface.knotsV().domainEnd() : surface.knotsV().domainStart();
        record.corners[corner] = gpu::vec3(evaluate(surface, u, v).position - frame.origin);
    }
    record.colour = {linear(object.colour.red), linear(object.colour.green), linear(object.colour.blue)};
    return record;
}

}  // namespace knotspan
