#include "model/geometry/trim_loop.h"

#include <algorithm>
#include <cmath>

#include "model/core/check.h"
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

// Relative to one of the control points, so that a place far away costs no digits.
TrimCurve::Look TrimCurve::look(double t) const
{
    t = knots_.inDomain(t);
    const int span = knots_.findSpan(t);
    const auto degree = static_cast<size_t>(knots_.degree());
    const BasisOfDegrees basis = basisOfDegrees(knots_, span, t);
    const size_t first = static_cast<size_t>(span) - degree;
    const Vec2 origin = points_[first].position;
    const auto homogeneous = [&](size_t k) {
        const TrimPoint& point = points_[first + k];
        return point.weight * Vec3(point.position - origin, 1);
    };
    Vec3 sum{0};
    Vec3 change{0};
    for (size_t k = 0; k <= degree; ++k)
        sum += basis[0][k] * homogeneous(k);
    for (size_t k = 0; k < degree; ++k) {
        const auto knot = static_cast<int>(first + k + 1);
        const double length = knots_[knot + knots_.degree()] - knots_[knot];
        change += basis[1][k] * knots_.degree() / length * (homogeneous(k + 1) - homogeneous(k));
    }
    const Vec2 at = Vec2(sum) / sum.z;
    return {origin + at, (Vec2(change) - change.z * at) / sum.z};
}

Vec2 TrimCurve::evaluate(double t) const
{
    return look(t).at;
}

Vec2 TrimCurve::derivative(double t) const
{
    return look(t).slope;
}

std::vector<TrimLoop> withBorder(std::vector<TrimLoop> loops, const KnotVector& knotsU,
                                 const KnotVector& knotsV)
{
    if (loops.empty() ||
        std::any_of(loops.begin(), loops.end(), [](const TrimLoop& loop) { return loop.outer; }))
        return loops;
    const Vec2 corners[] = {{knotsU.domainStart(), knotsV.domainStart()},
                            {knotsU.domainEnd(), knotsV.domainStart()},
                            {knotsU.domainEnd(), knotsV.domainEnd()},
                            {knotsU.domainStart(), knotsV.domainEnd()}};
    TrimLoop border;
    for (int k = 0; k < 4; ++k) {
        auto side =
            TrimCurve::create(KnotVector::clampedUniform(1, 1), {{corners[k]}, {corners[(k + 1) % 4]}});
        check(side.has_value(), "a side of a domain is a line");
        border.curves.push_back(*std::move(side));
    }
    loops.insert(loops.begin(), std::move(border));
    return loops;
}

}  // namespace knotspan
