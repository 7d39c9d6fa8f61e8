#include "model/geometry/knot_insertion.h"

#include <algorithm>

#include "model/core/check.h"
#include "model/geometry/net_rows.h"

namespace knotspan {

namespace {

// (1 - a) A + a B in homogeneous space, written so that equal points and equal weights stay what they are, to
// the bit, and nothing is lost far from the origin.
ControlPoint blended(const ControlPoint& first, const ControlPoint& second, double a)
{
    const double weight = first.weight + a * (second.weight - first.weight);
    const double share = first.weight == second.weight ? a : a * second.weight / weight;
    return {first.position + share * (second.position - first.position), weight};
}

// The index of the last knot that is not above `value`, in the whole vector.
int lastNotAbove(const KnotVector& knots, double value)
{
    const auto& values = knots.values();
    return static_cast<int>(std::upper_bound(values.begin(), values.end(), value) - values.begin()) - 1;
}

int multiplicity(const KnotVector& knots, double value)
{
    return static_cast<int>(std::count(knots.values().begin(), knots.values().end(), value));
}

NurbsSurface withKnots(const NurbsSurface& surface, Direction direction, std::vector<double> knots,
                       std::vector<ControlPoint> points)
{
    auto created = KnotVector::create(knotsAlong(surface, direction).degree(), std::move(knots));
    check(created.has_value(), "inserting within the allowed multiplicity leaves a valid knot vector");
    return withKnotsAlong(surface, direction, *std::move(created), std::move(points));
}

NurbsSurface withKnotInsertedOnce(const NurbsSurface& surface, Direction direction, double value)
{
    const KnotVector& knots = knotsAlong(surface, direction);
    const int p = knots.degree();
    const int k = lastNotAbove(knots, value);
    const int s = multiplicity(knots, value);
    check(value >= knots.domainStart() && value <= knots.domainEnd() && s < p,
          "a knot is inserted inside the domain and at most degree times");
    auto points = rowByRow(surface, direction, knots.controlPointCount() + 1, [&](const auto& at, int i) {
        if (i <= k - p)
            return at(i);
        if (i > k - s)
            return at(i - 1);
        return blended(at(i - 1), at(i), (value - knots[i]) / (knots[i + p] - knots[i]));
    });
    std::vector<double> values = knots.values();
    values.insert(values.begin() + k + 1, value);
    return withKnots(surface, direction, std::move(values), std::move(points));
}

}  // namespace

NurbsSurface withKnotInserted(const NurbsSurface& surface, Direction direction, double value, int times)
{
    NurbsSurface result = surface;
    for (int n = 0; n < times; ++n)
        result = withKnotInsertedOnce(result, direction, value);
    return result;
}

NurbsSurface withKnotsInserted(const NurbsSurface& surface, Direction direction,
                               const std::vector<double>& values)
{
    NurbsSurface result = surface;
    for (const double value : values)
        result = withKnotInsertedOnce(result, direction, value);
    return result;
}

NurbsSurface clampedPart(const NurbsSurface& surface, Direction direction, double start, double end)
{
    const int p = knotsAlong(surface, direction).degree();
    check(start < end, "a part of a surface has a length");
    NurbsSurface refined = surface;
    for (const double value : {start, end})
        refined = withKnotInserted(refined, direction, value,
                                   std::max(0, p - multiplicity(knotsAlong(refined, direction), value)));

    // After p copies of a knot whose last has index k, control point k - p lies on the surface.
    const KnotVector& knots = knotsAlong(refined, direction);
    const int surplus = multiplicity(knots, start) - p;  // 1 at a clamped start
    const int first = lastNotAbove(knots, start) - p;
    const int last =
        lastNotAbove(knots, end) - p - (multiplicity(knots, end) - p);  // likewise at a clamped end
    check(surplus <= 1, "a knot stands at most degree + 1 times");
    std::vector<double> values(static_cast<size_t>(p) + 1, start);
    values.insert(values.end(), knots.values().begin() + first + p + 1, knots.values().begin() + last + 1);
    values.insert(values.end(), static_cast<size_t>(p) + 1, end);
    auto points =
        rowByRow(refined, direction, last - first + 1, [&](const auto& at, int k) { return at(first + k); });
    return withKnots(refined, direction, std::move(values), std::move(points));
}

}  // namespace knotspan
