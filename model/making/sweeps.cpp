#include "model/making/sweeps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "model/geometry/arcs.h"
#include "model/making/numbers.h"

namespace knotspan {

namespace {

// Of a few coordinates taken together, relative to the largest.
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

// The largest of the coordinates' magnitudes: what their rounding is relative to.
double reach(const Vec3& place)
{
    return std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)});
}

double reach(const NurbsCurve& curve)
{
    return std::max(reach(curve.bounds().low), reach(curve.bounds().high));
}

Result<void> requireCurve(const NurbsCurve& curve)
{
    if (reach(curve) > kLargestSize)
        return failure("The curve is further away than can be drawn", "Choose another curve");
    return {};
}

// A control point of the curve, and what it turns in: its distance from the axis as a vector, and that a
// quarter further on.
struct Spoke {
    ControlPoint point;
    Vec3 out;
    Vec3 quarter;
};

std::vector<Spoke> spokesOf(const NurbsCurve& curve, const Vec3& origin, const Vec3& axis)
{
    std::vector<Spoke> spokes;
    double size = 0;
    for (const ControlPoint& point : curve.controlPoints()) {
        const Vec3 from = point.position - origin;
        const Vec3 out = from - glm::dot(from, axis) * axis;
        spokes.push_back({point, out, glm::cross(axis, out)});
        size = std::max(size, glm::length(from));
    }
    const double touching = 1e-13 * size + kRounding * std::max(reach(curve), reach(origin));
    for (Spoke* const end : {&spokes.front(), &spokes.back()})
        if (glm::length(end->out) <= touching) {
            end->point.position -= end->out;
            end->out = end->quarter = Vec3(0);
        }
    // Rounding alone takes no point of a line on the axis further away than this.
    if (std::all_of(spokes.begin(), spokes.end(),
                    [&](const Spoke& spoke) { return glm::length(spoke.out) <= touching; }))
        spokes.clear();
    return spokes;
}

}  // namespace

Result<NurbsSurface> extruded(const NurbsCurve& curve, const Vec3& vector)
{
    if (auto valid = requireCurve(curve); !valid)
        return tl::unexpected(valid.error());
    if (auto place = requirePlace("The vector", vector); !place)
        return tl::unexpected(place.error());
    const auto direction = requireDirection("The vector", vector);
    if (!direction)
        return tl::unexpected(direction.error());
    if (glm::length(vector) <= 1e-12 * reach(curve))
        return failure("The vector is too short for a curve so far from the origin", "Give a longer one");
    const Vec3 start = curve.controlPoints().front().position;
    double across = 0;
    for (const ControlPoint& point : curve.controlPoints())
        across = std::max(across, glm::length(glm::cross(point.position - start, *direction)));
    if (across <= 1e-12 * curve.bounds().diagonal() + kRounding * reach(curve))
        return failure("The curve is a point or runs along the vector, so that no area is swept",
                       "Choose another curve or another direction");
    std::vector<ControlPoint> points;
    for (const ControlPoint& point : curve.controlPoints()) {
        points.push_back(point);
        points.push_back({point.position + vector, point.weight});
    }
    return NurbsSurface::create(curve.knots(), KnotVector::clampedUniform(1, 1), std::move(points));
}

Result<NurbsSurface> revolved(const NurbsCurve& curve, const RevolvingAxis& axis, double degrees)
{
    if (auto valid = requireCurve(curve); !valid)
        return tl::unexpected(valid.error());
    if (auto place = requirePlace("The axis' point", axis.point); !place)
        return tl::unexpected(place.error());
    const auto direction = requireDirection("The axis", axis.direction);
    if (!direction)
        return tl::unexpected(direction.error());
    if (!(std::abs(degrees) >= 1e-6 && std::abs(degrees) <= 360))
        return failure("The angle is zero, more than a full turn, or no number",
                       "Give one of up to 360 degrees either way");
    const std::vector<Spoke> spokes = spokesOf(curve, axis.point, *direction);
    if (spokes.empty())
        return failure("The curve lies on the axis, so that no area is swept", "Choose another axis");
    const std::vector<ArcPoint> arc = arcPoints(degrees);
    std::vector<ControlPoint> points;
    for (const ArcPoint& around : arc)
        for (const auto& [point, out, quarter] : spokes)
            points.push_back(
                {point.position + ((around.x - 1) * out + around.y * quarter), around.weight * point.weight});
    return NurbsSurface::create(arcKnots(static_cast<int>(arc.size()) / 2), curve.knots(), std::move(points));
}

}  // namespace knotspan
