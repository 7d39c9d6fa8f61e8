#include "model/geometry/orientation.h"

#include <algorithm>
#include <cmath>

#include "model/geometry/net_rows.h"

namespace knotspan {

namespace {

// Written so that 0 stays 0 and does not become -0.
double negated(double number)
{
    return 0.0 - number;
}

KnotVector negated(const KnotVector& knots)
{
    std::vector<double> values(knots.values().rbegin(), knots.values().rend());
    for (double& value : values)
        value = negated(value);
    auto result = KnotVector::create(knots.degree(), std::move(values));
    check(result.has_value(), "knots turned round are valid");
    return *std::move(result);
}

double mapped(double value, double oldStart, double oldEnd, double start, double end)
{
    return std::lerp(start, end, (value - oldStart) / (oldEnd - oldStart));
}

// Each curve's points changed; and, where `turned`, the order of curves and points as well.
template <class Change>
TrimLoop changed(const TrimLoop& loop, bool turned, const Change& change)
{
    TrimLoop result{loop.outer, {}};
    for (const TrimCurve& curve : loop.curves) {
        std::vector<TrimPoint> points = curve.points();
        for (TrimPoint& point : points)
            point.position = change(point.position);
        if (turned)
            std::reverse(points.begin(), points.end());
        auto made = TrimCurve::create(turned ? negated(curve.knots()) : curve.knots(), std::move(points));
        check(made.has_value(), "trim points moved within the numbers are valid");
        result.curves.push_back(*std::move(made));
    }
    if (turned)
        std::reverse(result.curves.begin(), result.curves.end());
    return result;
}

}  // namespace

NurbsSurface reversed(const NurbsSurface& surface, Direction direction)
{
    const int last = knotsAlong(surface, direction).controlPointCount() - 1;
    auto points = rowByRow(surface, direction, last + 1, [&](const auto& at, int k) { return at(last - k); });
    return withKnotsAlong(surface, direction, negated(knotsAlong(surface, direction)), std::move(points));
}

NurbsSurface swapped(const NurbsSurface& surface)
{
    std::vector<ControlPoint> points;
    points.reserve(surface.controlPoints().size());
    for (int j = 0; j < surface.countV(); ++j)
        for (int i = 0; i < surface.countU(); ++i)
            points.push_back(surface.controlPoint(i, j));
    auto result = NurbsSurface::create(surface.knotsV(), surface.knotsU(), std::move(points));
    check(result.has_value(), "a net seen the other way is valid");
    return *std::move(result);
}

Result<NurbsSurface> withDomain(const NurbsSurface& surface, Direction direction, double start, double end)
{
    if (!std::isfinite(start) || !std::isfinite(end) || !(start < end))
        return failure("The new domain has no length or is not finite", "Give an end above the start");
    const KnotVector& knots = knotsAlong(surface, direction);
    std::vector<double> values = knots.values();
    for (double& value : values)
        value = mapped(value, knots.domainStart(), knots.domainEnd(), start, end);
    auto made = KnotVector::create(knots.degree(), std::move(values));
    if (!made)
        return tl::unexpected(made.error());
    return withKnotsAlong(surface, direction, *std::move(made), surface.controlPoints());
}

TrimLoop reversed(const TrimLoop& loop, Direction direction)
{
    return changed(loop, true, [direction](const Vec2& at) {
        return direction == Direction::U ? Vec2(negated(at.x), at.y) : Vec2(at.x, negated(at.y));
    });
}

TrimLoop swapped(const TrimLoop& loop)
{
    return changed(loop, true, [](const Vec2& at) { return Vec2(at.y, at.x); });
}

TrimLoop withDomain(const TrimLoop& loop, Direction direction, double oldStart, double oldEnd, double start,
                    double end)
{
    return changed(loop, false, [&](const Vec2& at) {
        return direction == Direction::U ? Vec2(mapped(at.x, oldStart, oldEnd, start, end), at.y)
                                         : Vec2(at.x, mapped(at.y, oldStart, oldEnd, start, end));
    });
}

}  // namespace knotspan
