// Trim loops from the curves of an OBJ file.
#include <algorithm>

#include "model/core/check.h"
#include "model/formats/obj_elements.h"
#include "model/formats/obj_range.h"

namespace knotspan::formats {

namespace {

// Only its sign is used.
double signedArea(const TrimLoop& loop)
{
    std::vector<Vec2> polygon;
    for (const TrimCurve& curve : loop.curves) {
        const KnotVector& knots = curve.knots();
        // Few a span where there are many: a small file may use a long curve again and again.
        const int samples =
            knots.degree() == 1 ? 1 : std::clamp(256 / static_cast<int>(knots.spans().size()), 1, 16);
        for (const int span : knots.spans())
            for (int k = 0; k < samples; ++k)
                polygon.push_back(
                    curve.evaluate(knots[span] + (knots[span + 1] - knots[span]) * k / samples));
    }
    double area = 0;
    for (size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k] - polygon[0];
        const Vec2 b = polygon[(k + 1) % polygon.size()] - polygon[0];
        area += (a.x * b.y - a.y * b.x) / 2;
    }
    return area;
}

// The parameter becomes its negative: nothing is rounded.
TrimCurve reversed(const TrimCurve& curve)
{
    std::vector<double> values(curve.knots().values().rbegin(), curve.knots().values().rend());
    for (double& value : values)
        value = 0.0 - value;
    auto knots = KnotVector::create(curve.knots().degree(), std::move(values));
    check(knots.has_value(), "knots turned round are valid");
    auto result = TrimCurve::create(*std::move(knots), {curve.points().rbegin(), curve.points().rend()});
    check(result.has_value(), "points in the other order are valid");
    return *std::move(result);
}

void turnRound(TrimLoop& loop)
{
    std::reverse(loop.curves.begin(), loop.curves.end());
    for (TrimCurve& curve : loop.curves)
        curve = reversed(curve);
}

TrimLoop borderOf(const NurbsSurface& surface)
{
    const Vec2 low{surface.knotsU().domainStart(), surface.knotsV().domainStart()};
    const Vec2 high{surface.knotsU().domainEnd(), surface.knotsV().domainEnd()};
    const Vec2 corners[5] = {low, {high.x, low.y}, high, {low.x, high.y}, low};
    TrimLoop loop{true, {}};
    for (int side = 0; side < 4; ++side) {
        auto line =
            TrimCurve::create(KnotVector::clampedUniform(1, 1), {{corners[side], 1}, {corners[side + 1], 1}});
        check(line.has_value(), "the side of a domain is a curve");
        loop.curves.push_back(*std::move(line));
    }
    return loop;
}

Result<TrimCurve> curveOf(const ObjTrim& trim, const TrimCurve& curve)
{
    const bool backwards = trim.end < trim.start;
    const auto range =
        rangeIn(curve.knots(), {std::min(trim.start, trim.end), std::max(trim.start, trim.end)});
    if (!range)
        return tl::unexpected(range.error());
    return partOf(curve, *range).map([&](TrimCurve&& part) { return backwards ? reversed(part) : part; });
}

Result<TrimLoop> loopOf(const ObjLoop& loop, const std::vector<Result<TrimCurve>>& curves)
{
    TrimLoop result{loop.outer, {}};
    for (const ObjTrim& trim : loop.trims) {
        const std::string name = "Trimming curve " + std::to_string(trim.curve + 1);
        const Result<TrimCurve>& whole = curves[trim.curve];
        if (!whole)
            return failure(name + " is none: " + whole.error().what);
        auto part = curveOf(trim, *whole);
        if (!part)
            return failure(name + ": " + part.error().what);
        result.curves.push_back(*std::move(part));
    }
    const double area = signedArea(result);
    if (loop.outer ? area < 0 : area > 0)
        turnRound(result);
    return result;
}

}  // namespace

Result<std::vector<TrimLoop>> trimLoopsOf(const std::vector<ObjLoop>& loops,
                                          const std::vector<Result<TrimCurve>>& curves,
                                          const NurbsSurface& surface)
{
    std::vector<TrimLoop> result;
    if (!loops.empty() && !loops.front().outer)
        result.push_back(borderOf(surface));
    for (const ObjLoop& loop : loops) {
        auto made = loopOf(loop, curves);
        if (!made)
            return tl::unexpected(made.error());
        result.push_back(*std::move(made));
    }
    return result;
}

}  // namespace knotspan::formats
