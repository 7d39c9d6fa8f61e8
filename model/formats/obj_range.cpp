#include "model/formats/obj_range.h"

#include <algorithm>
#include <cmath>

#include "model/files/text_file.h"
#include "model/geometry/knot_insertion.h"

namespace knotspan::formats {

namespace {

std::string textOf(double start, double end)
{
    std::string text;
    append(text, start);
    text += " to ";
    append(text, end);
    return text;
}

bool isWhole(const KnotVector& knots, ObjRange range)
{
    return range.start == knots.domainStart() && range.end == knots.domainEnd();
}

// Blending control points neither overflows nor makes a weight zero.
Result<void> requireModest(const std::vector<ControlPoint>& points)
{
    constexpr double kLargest = 1e150;
    constexpr double kLargestRatio = 1e12;
    double least = points.front().weight;
    double most = least;
    double farthest = 0;
    for (const ControlPoint& point : points) {
        least = std::min(least, point.weight);
        most = std::max(most, point.weight);
        for (int axis = 0; axis < 3; ++axis)
            farthest = std::max(farthest, std::abs(point.position[axis]));
    }
    if (farthest > kLargest || most > kLargest || least < 1 / kLargest || most / least > kLargestRatio)
        return failure("Its range is a part of its knots' domain, and its numbers are too extreme to cut it");
    return {};
}

}  // namespace

Result<ObjRange> rangeIn(const KnotVector& knots, ObjRange asked)
{
    constexpr double kSame = 1e-9;
    constexpr double kRounded = 1e-6;
    const double start = knots.domainStart();
    const double end = knots.domainEnd();
    const double length = end - start;
    const ObjRange result{asked.start <= start + kSame * length ? start : asked.start,
                          asked.end >= end - kSame * length ? end : asked.end};
    if (!(asked.start >= start - kRounded * length && asked.end <= end + kRounded * length))
        return failure("The range " + textOf(asked.start, asked.end) + " leaves the knots' domain " +
                       textOf(start, end));
    if (!(asked.start < asked.end && result.start < result.end))
        return failure("The range " + textOf(asked.start, asked.end) + " is empty");
    return result;
}

Result<NurbsSurface> partOf(const NurbsSurface& surface, ObjRange u, ObjRange v)
{
    if (isWhole(surface.knotsU(), u) && isWhole(surface.knotsV(), v))
        return surface;
    if (auto modest = requireModest(surface.controlPoints()); !modest)
        return tl::unexpected(modest.error());
    NurbsSurface part = surface;
    if (!isWhole(surface.knotsU(), u))
        part = clampedPart(part, Direction::U, u.start, u.end);
    if (!isWhole(surface.knotsV(), v))
        part = clampedPart(part, Direction::V, v.start, v.end);
    return part;
}

// The curve as one side of a surface, because knots are inserted into surfaces.
Result<TrimCurve> partOf(const TrimCurve& curve, ObjRange range)
{
    if (isWhole(curve.knots(), range))
        return curve;
    std::vector<ControlPoint> rows;
    for (const TrimPoint& point : curve.points())
        rows.insert(rows.end(), 2, ControlPoint{Vec3(point.position, 0), point.weight});
    if (auto modest = requireModest(rows); !modest)
        return tl::unexpected(modest.error());
    return NurbsSurface::create(curve.knots(), KnotVector::clampedUniform(1, 1), std::move(rows))
        .and_then([&](const NurbsSurface& ruled) {
            const NurbsSurface part = clampedPart(ruled, Direction::U, range.start, range.end);
            std::vector<TrimPoint> points;
            for (int i = 0; i < part.countU(); ++i)
                points.push_back({Vec2(part.controlPoint(i, 0).position), part.controlPoint(i, 0).weight});
            return TrimCurve::create(part.knotsU(), std::move(points));
        });
}

}  // namespace knotspan::formats
