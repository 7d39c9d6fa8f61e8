#include "model/analysis/bezier_curves.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

Box boundsOf(const BezierNet& curve)
{
    Box box;
    for (const Vec4& point : curve.points)
        box.add(pointOf(point));
    return box;
}

BezierNet elevated(const BezierNet& curve, int degree)
{
    BezierNet result = curve;
    while (result.degreeU < degree) {
        const int p = ++result.degreeU;
        result.points.push_back(result.points.back());
        for (int k = p - 1; k > 0; --k) {
            const double share = static_cast<double>(k) / p;
            result.at(k, 0) = share * result.at(k - 1, 0) + (1 - share) * result.at(k, 0);
        }
    }
    return result;
}

BezierNet part(const BezierNet& curve, double start, double end)
{
    const double low = std::min(start, end);
    const double high = std::max(start, end);
    BezierNet result = curve;
    if (high < 1.0)
        result = split(result, Direction::U, high).first;
    if (low > 0.0)
        result = split(result, Direction::U, low / std::min(high, 1.0)).second;
    if (start > end)
        std::reverse(result.points.begin(), result.points.end());
    return result;
}

bool sameCurve(const BezierNet& a, const BezierNet& b, double tolerance)
{
    constexpr double kWeightTolerance = 1e-6;
    const int degree = std::max(a.degreeU, b.degreeU);
    if (a.degreeU != degree)
        return sameCurve(elevated(a, degree), b, tolerance);
    if (b.degreeU != degree)
        return sameCurve(a, elevated(b, degree), tolerance);
    const double factor = a.points[0].w / b.points[0].w;
    for (size_t k = 0; k < a.points.size(); ++k) {
        const Vec4& p = a.points[k];
        const Vec4& q = b.points[k];
        // Written so that what is no number is not the same.
        if (!(glm::distance(pointOf(p), pointOf(q)) <= tolerance) ||
            !(std::abs(p.w - factor * q.w) <= kWeightTolerance * p.w))
            return false;
    }
    return true;
}

namespace {

constexpr double kApart = 1.0 / 1024;

struct OffsetAndSlope {
    Vec3 offset;
    Vec3 slope;
};

// Of a curve given relative to the point it is asked for.
OffsetAndSlope look(const BezierNet& curve, double t)
{
    std::vector<Vec4> points = curve.points;
    const int p = curve.degreeU;
    for (int level = p; level > 1; --level)
        for (size_t k = 0; k < static_cast<size_t>(level); ++k)
            points[k] = (1 - t) * points[k] + t * points[k + 1];
    const Vec4 value = (1 - t) * points[0] + t * points[1];
    const Vec4 change = static_cast<double>(p) * (points[1] - points[0]);
    const Vec3 offset = pointOf(value);
    return {offset, (Vec3(change) - change.w * offset) / value.w};
}

// Gauss-Newton towards the nearest place.
double nearest(const BezierNet& curve, double t)
{
    for (int step = 0; step < 12; ++step) {
        const auto [offset, slope] = look(curve, t);
        const double square = glm::dot(slope, slope);
        if (!(square > 0.0))
            break;
        const double next = std::clamp(t - glm::dot(offset, slope) / square, 0.0, 1.0);
        if (std::abs(next - t) < 1e-15)
            return next;
        t = next;
    }
    return t;
}

// The halves of halves whose control points enclose the point, down to parts that are as good as straight.
void collect(const BezierNet& whole, const BezierNet& piece, double start, double length, double tolerance,
             std::vector<double>& found)
{
    const Box box = boundsOf(piece);
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.low[axis] <= tolerance && box.high[axis] >= -tolerance))
            return;
    if (length > kApart) {
        const auto halves = split(piece, Direction::U);
        collect(whole, halves.first, start, length / 2, tolerance, found);
        collect(whole, halves.second, start + length / 2, length / 2, tolerance, found);
        return;
    }
    const double t = nearest(whole, start + length / 2);
    const bool known =
        std::any_of(found.begin(), found.end(), [&](double other) { return std::abs(other - t) < kApart; });
    if (!known && glm::length(look(whole, t).offset) <= tolerance)
        found.push_back(t);
}

}  // namespace

std::vector<double> parametersAt(const BezierNet& curve, const Vec3& point, double tolerance)
{
    BezierNet relative = curve;
    for (Vec4& p : relative.points)
        p = Vec4(Vec3(p) - p.w * point, p.w);
    std::vector<double> found;
    collect(relative, relative, 0, 1, tolerance, found);
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace knotspan
