#include "model/geometry/nurbs_curve.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/geometry/basis.h"
#include "model/geometry/net_rows.h"

namespace knotspan {

namespace {

bool isFinite(const Vec3& point)
{
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

std::string text(double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.4g", value);
    return buffer;
}

}  // namespace

Result<NurbsCurve> NurbsCurve::create(KnotVector knots, std::vector<ControlPoint> controlPoints)
{
    if (controlPoints.size() != static_cast<size_t>(knots.controlPointCount()))
        return failure("The knots ask for " + std::to_string(knots.controlPointCount()) +
                       " control points, but there are " + std::to_string(controlPoints.size()));
    for (size_t i = 0; i < controlPoints.size(); ++i) {
        const std::string name = "Control point " + std::to_string(i);
        if (!isFinite(controlPoints[i].position))
            return failure(name + " has a coordinate that is not a finite number");
        if (!std::isfinite(controlPoints[i].weight))
            return failure(name + " has a weight that is not a finite number");
        if (!(controlPoints[i].weight > 0))
            return failure(name + " has a weight that is not above zero");
    }
    return NurbsCurve(std::move(knots), std::move(controlPoints));
}

NurbsCurve::NurbsCurve(KnotVector knots, std::vector<ControlPoint> controlPoints)
    : knots_(std::move(knots)),
      controlPoints_(std::move(controlPoints))
{
    for (const ControlPoint& point : controlPoints_)
        bounds_.add(point.position);
}

// The NURBS Book, A4.1, relative to the control point that counts most, so that a place far away costs no
// digits, and with weights relative to the greatest, so that no sum of them leaves the range of double.
Vec3 evaluate(const NurbsCurve& curve, double t)
{
    const KnotVector& knots = curve.knots();
    t = knots.inDomain(t);
    const int span = knots.findSpan(t);
    const auto degree = static_cast<size_t>(knots.degree());
    const ControlPoint* const points = curve.controlPoints().data() + (static_cast<size_t>(span) - degree);
    double greatest = 0;
    for (size_t k = 0; k <= degree; ++k)
        greatest = std::max(greatest, points[k].weight);
    BasisRow shares = basisOfDegrees(knots, span, t)[0];
    double sum = 0;
    for (size_t k = 0; k <= degree; ++k)
        sum += shares[k] *= points[k].weight / greatest;
    const auto heaviest =
        static_cast<size_t>(std::max_element(shares.begin(), shares.begin() + degree + 1) - shares.begin());
    const Vec3 origin = points[heaviest].position;
    Vec3 away{0};
    for (size_t k = 0; k <= degree; ++k)
        away += shares[k] / sum * (points[k].position - origin);
    return origin + away;
}

Result<NurbsCurve> isoCurve(const NurbsSurface& surface, Direction across, double parameter)
{
    const KnotVector& knots = knotsAlong(surface, across);
    if (!(parameter >= knots.domainStart() && parameter <= knots.domainEnd()))
        return failure(text(parameter) + " is not inside the surface's domain",
                       "Choose a parameter from " + text(knots.domainStart()) + " to " +
                           text(knots.domainEnd()));
    const int p = knots.degree();
    const auto there = static_cast<int>(std::count(knots.values().begin(), knots.values().end(), parameter));
    const NurbsSurface refined = withKnotInserted(surface, across, parameter, std::max(0, p - there));
    // After p copies of a knot whose last has index k, control point k - p lies on the surface; at a clamped
    // end there is one copy more.
    const auto& values = knotsAlong(refined, across).values();
    const auto last =
        static_cast<int>(std::upper_bound(values.begin(), values.end(), parameter) - values.begin()) - 1;
    const int row = std::min(last - p, knotsAlong(refined, across).controlPointCount() - 1);
    const bool alongV = across == Direction::U;
    std::vector<ControlPoint> points;
    for (int k = 0; k < (alongV ? refined.countV() : refined.countU()); ++k)
        points.push_back(alongV ? refined.controlPoint(row, k) : refined.controlPoint(k, row));
    return NurbsCurve::create(alongV ? surface.knotsV() : surface.knotsU(), std::move(points));
}

NurbsCurve reversed(const NurbsCurve& curve)
{
    std::vector<double> values(curve.knots().values().rbegin(), curve.knots().values().rend());
    for (double& value : values)
        value = 0.0 - value;  // 0 stays 0 and does not become -0
    auto knots = KnotVector::create(curve.degree(), std::move(values));
    check(knots.has_value(), "knots turned round are valid");
    const auto& points = curve.controlPoints();
    auto result = NurbsCurve::create(*std::move(knots), {points.rbegin(), points.rend()});
    check(result.has_value(), "a curve turned round is valid");
    return *std::move(result);
}

Result<NurbsCurve> transformed(const NurbsCurve& curve, const Mat4& transform)
{
    std::vector<ControlPoint> points = curve.controlPoints();
    for (ControlPoint& point : points)
        point.position = transformed(point.position, transform);
    return NurbsCurve::create(curve.knots(), std::move(points));
}

}  // namespace knotspan
