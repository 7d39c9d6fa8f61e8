#include "model/geometry/trim_loop.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/basis.h"

namespace knotspan {

Result<TrimCurve> TrimCurve::create(KnotVector knots, std::vector<TrimPoint> points)
{
    if (points.size() != static_cast<size_t>(knots.controlPointCount()))
        return failure("The knots ask for " + std::to_string(knots.controlPointCount()) +
                       " control points, but there are " + std::to_string(points.size()));
    for (size_t i = 0; i < points.size(); ++i) {
        const TrimPoint& point = points[i];
        const std::string name = "Control point " + std::to_string(i);
        if (!std::isfinite(point.position.x) || !std::isfinite(point.position.y))
            return failure(name + " has a coordinate that is not a finite number");
        if (!std::isfinite(point.weight))
            return failure(name + " has a weight that is not a finite number");
        if (!(point.weight > 0))
            return failure(name + " has a weight that is not above zero");
    }
    return TrimCurve(std::move(knots), std::move(points));
}

TrimCurve::TrimCurve(KnotVector knots, std::vector<TrimPoint> points)
    : knots_(std::move(knots)),
      points_(std::move(points))
{
}

Vec2 TrimCurve::evaluate(double t) const
{
    t = std::clamp(t, knots_.domainStart(), knots_.domainEnd());
    const int span = knots_.findSpan(t);
    const BasisRow basis = basisOfDegrees(knots_, span, t)[0];
    const size_t first = static_cast<size_t>(span - knots_.degree());
    const Vec2 origin = points_[first].position;
    Vec2 sum{0};
    double weight = 0;
    for (size_t k = 0; k <= static_cast<size_t>(knots_.degree()); ++k) {
        const TrimPoint& point = points_[first + k];
        sum += basis[k] * point.weight * (point.position - origin);
        weight += basis[k] * point.weight;
    }
    return origin + sum / weight;
}

}  // namespace knotspan
