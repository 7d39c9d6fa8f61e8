// Trim loops from the curves of an OBJ file.
#include <algorithm>

#include "model/core/check.h"
#include "model/formats/obj_elements.h"
#include "model/formats/obj_range.h"
#include "model/geometry/loop_direction.h"

namespace knotspan::formats {

namespace {

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
    return partOf(curve, *range).map([&](TrimCurve&& part) {
        return backwards ? turnedRound({part}).front() : part;
    });
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
    const double area = signedArea(result.curves);
    if (loop.outer ? area < 0 : area > 0)
        result.curves = turnedRound(result.curves);
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
