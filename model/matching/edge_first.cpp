#include "model/matching/edge_first.h"

#include "model/core/check.h"
#include "model/geometry/orientation.h"

namespace knotspan {

namespace {

NurbsSurface withPoints(const NurbsSurface& surface, std::vector<ControlPoint> points)
{
    auto result = NurbsSurface::create(surface.knotsU(), surface.knotsV(), std::move(points));
    check(result.has_value(), "finite control points in the place of others are a valid net");
    return *std::move(result);
}

}  // namespace

NurbsSurface edgeFirst(const NurbsSurface& surface, Side side)
{
    switch (side) {
    case Side::startU:
        return surface;
    case Side::endU:
        return reversed(surface, Direction::U);
    case Side::startV:
        return swapped(surface);
    case Side::endV:
        break;
    }
    return swapped(reversed(surface, Direction::V));
}

NurbsSurface edgeBack(const NurbsSurface& surface, Side side)
{
    // The others undo themselves.
    return side == Side::endV ? reversed(swapped(surface), Direction::V) : edgeFirst(surface, side);
}

NurbsSurface clamped(const NurbsSurface& surface)
{
    const NurbsSurface inU =
        clampedPart(surface, Direction::U, surface.knotsU().domainStart(), surface.knotsU().domainEnd());
    return clampedPart(inU, Direction::V, surface.knotsV().domainStart(), surface.knotsV().domainEnd());
}

NurbsSurface placed(const NurbsSurface& surface, const Mat4& transform)
{
    if (transform == Mat4(1.0))
        return surface;
    std::vector<ControlPoint> points = surface.controlPoints();
    for (ControlPoint& point : points)
        point.position = transformed(point.position, transform);
    return withPoints(surface, std::move(points));
}

NurbsSurface withRow(const NurbsSurface& surface, int row, const std::vector<ControlPoint>& points)
{
    check(row >= 0 && row < surface.countU() && points.size() == static_cast<size_t>(surface.countV()),
          "a row of the net is replaced by one as long");
    std::vector<ControlPoint> net = surface.controlPoints();
    std::copy(points.begin(), points.end(), net.begin() + row * surface.countV());
    return withPoints(surface, std::move(net));
}

std::vector<ControlPoint> rowOf(const NurbsSurface& surface, int row)
{
    const auto first = surface.controlPoints().begin() + row * surface.countV();
    return {first, first + surface.countV()};
}

}  // namespace knotspan
