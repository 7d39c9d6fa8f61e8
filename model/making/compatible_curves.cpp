#include "model/making/compatible_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "model/core/check.h"
#include "model/geometry/basis.h"
#include "model/geometry/degree_elevation.h"
#include "model/geometry/orientation.h"

namespace knotspan {

namespace {

using KnotCounts = std::map<double, int>;  // an interior knot, and how often it stands there

// The curve as both borders of a surface, along u: so the functions of surfaces serve curves as well.
NurbsSurface ribbonOf(const NurbsCurve& curve)
{
    std::vector<ControlPoint> points;
    for (const ControlPoint& point : curve.controlPoints())
        points.insert(points.end(), 2, point);
    auto result = NurbsSurface::create(curve.knots(), KnotVector::clampedUniform(1, 1), std::move(points));
    check(result.has_value(), "a valid curve twice is a valid surface");
    return *std::move(result);
}

NurbsCurve curveOf(const NurbsSurface& ribbon)
{
    auto result = isoCurve(ribbon, Direction::V, ribbon.knotsV().domainStart());
    check(result.has_value(), "a border of a ribbon is a curve");
    return *std::move(result);
}

KnotCounts insideOf(const KnotVector& knots)
{
    KnotCounts counts;
    for (const double knot : knots.values())
        if (knot > knots.domainStart() && knot < knots.domainEnd())
            ++counts[knot];
    return counts;
}

// Clamped, of that degree, over that domain.
Result<NurbsSurface> prepared(const NurbsCurve& curve, int degree, const KnotVector& domain)
{
    const KnotVector& knots = curve.knots();
    const NurbsSurface clamped =
        clampedPart(ribbonOf(curve), Direction::U, knots.domainStart(), knots.domainEnd());
    NurbsSurface ribbon = withDegree(clamped, Direction::U, degree);
    if (knots.domainStart() == domain.domainStart() && knots.domainEnd() == domain.domainEnd())
        return ribbon;
    return withDomain(ribbon, Direction::U, domain.domainStart(), domain.domainEnd());
}

// Each knot that `known` has but for rounding taken to it; the others become known.
Result<NurbsSurface> snapped(const NurbsSurface& ribbon, std::vector<double>& known)
{
    const KnotVector& knots = ribbon.knotsU();
    const double scale = std::max(std::abs(knots.domainStart()), std::abs(knots.domainEnd()));
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * scale;
    std::vector<double> values = knots.values();
    for (double& value : values) {
        const auto after = std::lower_bound(known.begin(), known.end(), value);
        if (after != known.end() && *after - value <= rounding)
            value = *after;
        else if (after != known.begin() && value - *(after - 1) <= rounding)
            value = *(after - 1);
        else
            known.insert(after, value);
    }
    if (values == knots.values())
        return ribbon;
    auto created = KnotVector::create(knots.degree(), std::move(values));
    if (!created)
        return failure("Two knots of the curves lie too close together", "Remove one of the knots");
    return NurbsSurface::create(*std::move(created), ribbon.knotsV(), ribbon.controlPoints());
}

KnotVector withAllOf(const KnotVector& knots, const KnotCounts& all)
{
    const auto ends = static_cast<size_t>(knots.degree()) + 1;
    std::vector<double> values(ends, knots.domainStart());
    for (const auto& [knot, times] : all)
        values.insert(values.end(), static_cast<size_t>(times), knot);
    values.insert(values.end(), ends, knots.domainEnd());
    auto result = KnotVector::create(knots.degree(), std::move(values));
    check(result.has_value(), "no knot stands there more often than in one of the curves");
    return *std::move(result);
}

// Control point j of the finer curve is the blossom of the old one at the knots j + 1 .. j + degree; seen
// from the span in which knot j lies no share is below zero. All knots at once, where withKnotsInserted()
// would copy the net for each. Cohen, Lyche and Riesenfeld, Discrete B-splines and subdivision techniques
// (1980).
NurbsCurve refinedTo(const NurbsCurve& curve, const KnotVector& finer)
{
    const KnotVector& knots = curve.knots();
    const int p = knots.degree();
    std::vector<ControlPoint> points;
    for (int j = 0; j < finer.controlPointCount(); ++j) {
        const int span = knots.findSpan(finer[j]);
        BasisRow shares{1.0};
        for (int d = 1; d <= p; ++d)
            raiseDegree(knots, span, finer[j + d], d, shares);
        const ControlPoint* const old = curve.controlPoints().data() + (span - p);
        const auto heaviest = std::max_element(shares.begin(), shares.begin() + p + 1) - shares.begin();
        const ControlPoint& origin = old[heaviest];
        double weight = origin.weight;
        Vec3 sum{0};
        for (int k = 0; k <= p; ++k) {
            const double share = shares[static_cast<size_t>(k)];
            weight += share * (old[k].weight - origin.weight);
            sum += share * old[k].weight * (old[k].position - origin.position);
        }
        points.push_back({origin.position + sum / weight, weight});
    }
    auto result = NurbsCurve::create(finer, std::move(points));
    check(result.has_value(), "means of valid control points are valid");
    return *std::move(result);
}

}  // namespace

Result<std::vector<NurbsCurve>> compatibleCurves(const std::vector<NurbsCurve>& curves)
{
    check(!curves.empty(), "there is a curve");
    int degree = 0;
    for (const NurbsCurve& curve : curves)
        degree = std::max(degree, curve.degree());
    std::vector<NurbsSurface> ribbons;
    std::vector<double> known{curves.front().knots().domainStart(), curves.front().knots().domainEnd()};
    KnotCounts all;
    for (const NurbsCurve& curve : curves) {
        auto ribbon = prepared(curve, degree, curves.front().knots());
        if (ribbon)
            ribbon = snapped(*ribbon, known);
        if (!ribbon)
            return tl::unexpected(ribbon.error());
        for (const auto& [knot, times] : insideOf(ribbon->knotsU()))
            all[knot] = std::max(all[knot], times);
        ribbons.push_back(*std::move(ribbon));
    }
    int count = degree + 1;
    for (const auto& [knot, times] : all)
        count += times;
    if (static_cast<double>(count) * static_cast<double>(curves.size()) > 1e6)
        return failure("Together the curves have so many knots that the surface would be too large",
                       "Take fewer curves, or simpler ones");
    std::vector<NurbsCurve> result;
    const KnotVector knots = withAllOf(ribbons.front().knotsU(), all);
    for (const NurbsSurface& ribbon : ribbons) {
        const NurbsCurve curve = curveOf(ribbon);
        result.push_back(curve.knots() == knots ? curve : refinedTo(curve, knots));
    }
    return result;
}

}  // namespace knotspan
