#include "renderer/scene/patch_table.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/common.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

// Beyond 1e30 spans the share of the neighbour is less than float can tell from nothing.
float normalised(double difference, double length)
{
    return static_cast<float>(std::min(difference / length, 1e30));
}

// Where each span of a direction starts in the packed knots, in the order of KnotVector::spans().
std::vector<std::uint32_t> packDirection(const KnotVector& knots, std::vector<float>& to)
{
    std::vector<std::uint32_t> starts;
    for (const int span : knots.spans()) {
        starts.push_back(static_cast<std::uint32_t>(to.size()));
        appendSpanKnots(knots, span, to);
    }
    return starts;
}

float linear(double encoded)
{
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92
                                                 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

}  // namespace

void appendSpanKnots(const KnotVector& knots, int span, std::vector<float>& to)
{
    const double start = knots[span];
    const double end = knots[span + 1];
    for (int j = 1; j <= knots.degree(); ++j)
        to.push_back(normalised(start - knots[span + 1 - j], end - start));
    for (int j = 1; j <= knots.degree(); ++j)
        to.push_back(normalised(knots[span + j] - end, end - start));
}

PatchTable makePatchTable(const NurbsSurface& surface)
{
    PatchTable table;
    const auto startsU = packDirection(surface.knotsU(), table.spanKnots);
    const auto startsV = packDirection(surface.knotsV(), table.spanKnots);
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

gpu::vec4 PointFrame::pack(const ControlPoint& point) const
{
    // Not zero: a point of no weight that shapes a KSQuad alone would be nowhere.
    const double scaled = std::max(point.weight / weight, 1e-30);
    return gpu::vec4(Vec4((point.position - origin) * scaled, scaled));
}

std::vector<gpu::vec4> packPoints(const PointFrame& frame, std::span<const ControlPoint> points)
{
    std::vector<gpu::vec4> packed(points.size());
    std::transform(points.begin(), points.end(), packed.begin(),
                   [&](const ControlPoint& point) { return frame.pack(point); });
    return packed;
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
    for (int corner = 0; corner < 4; ++corner) {
        const double u = (corner & 1) != 0 ? surface.knotsU().domainEnd() : surface.knotsU().domainStart();
        const double v = (corner & 2) != 0 ? surface.knotsV().domainEnd() : surface.knotsV().domainStart();
        record.corners[corner] = gpu::vec3(evaluate(surface, u, v).position - frame.origin);
    }
    record.colour = {linear(object.colour.red), linear(object.colour.green), linear(object.colour.blue)};
    return record;
}

}  // namespace knotspan
