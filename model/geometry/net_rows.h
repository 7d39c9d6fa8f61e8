// What functions from surface to surface share that change one direction and treat each row of the net along
// it alike.
#pragma once

#include "model/core/check.h"
#include "model/geometry/knot_insertion.h"

namespace knotspan {

[[nodiscard]] inline const KnotVector& knotsAlong(const NurbsSurface& surface, Direction direction)
{
    return direction == Direction::U ? surface.knotsU() : surface.knotsV();
}

// The surface with other knots (and degree) along `direction` and the net that goes with them.
[[nodiscard]] inline NurbsSurface withKnotsAlong(const NurbsSurface& surface, Direction direction,
                                                 KnotVector knots, std::vector<ControlPoint> points)
{
    auto result = direction == Direction::U
                      ? NurbsSurface::create(std::move(knots), surface.knotsV(), std::move(points))
                      : NurbsSurface::create(surface.knotsU(), std::move(knots), std::move(points));
    check(result.has_value(), "control points between valid ones are valid");
    return *std::move(result);
}

// The net with each row along `direction` replaced: newPoint(at, k) gives its k-th point, where at(k) is the
// old row's.
template <class NewPoint>
[[nodiscard]] std::vector<ControlPoint> rowByRow(const NurbsSurface& surface, Direction direction,
                                                 int newCount, const NewPoint& newPoint)
{
    const bool alongU = direction == Direction::U;
    const int rows = alongU ? surface.countV() : surface.countU();
    const int stride = alongU ? surface.countV() : newCount;
    std::vector<ControlPoint> points(static_cast<size_t>(newCount) * static_cast<size_t>(rows));
    for (int row = 0; row < rows; ++row) {
        const auto at = [&](int k) -> const ControlPoint& {
            return alongU ? surface.controlPoint(k, row) : surface.controlPoint(row, k);
        };
        for (int k = 0; k < newCount; ++k)
            points[static_cast<size_t>(alongU ? k * stride + row : row * stride + k)] = newPoint(at, k);
    }
    return points;
}

}  // namespace knotspan
