#include "model/geometry/degree_elevation.h"

#include <algorithm>
#include <array>

#include "model/geometry/basis.h"
#include "model/geometry/net_rows.h"

namespace knotspan {

namespace {

// A new control point as a mean of degree + 1 old ones from `first` on.
struct Mean {
    int first = 0;
    BasisRow shares{};
};

// The same domain, each knot once more than before.
KnotVector elevatedKnots(const KnotVector& knots)
{
    std::vector<double> values;
    values.reserve(knots.values().size() * 2);
    for (size_t i = 0; i < knots.values().size(); ++i) {
        if (i == 0 || knots.values()[i] != knots.values()[i - 1])
            values.push_back(knots.values()[i]);
        values.push_back(knots.values()[i]);
    }
    auto result = KnotVector::create(knots.degree() + 1, std::move(values));
    check(result.has_value(), "raising the degree leaves a valid knot vector");
    return *std::move(result);
}

// Control point j of degree p + 1 is the blossom of degree p + 1 at the p + 1 knots after it, which is the
// mean of the old blossom over those knots without one of them. Seen from the span that begins at knot j each
// of these is a control point of a refinement of the old knots, so that no share is below zero. Prautzsch,
// Degree elevation of B-spline curves (1984).
Mean meanFor(const KnotVector& knots, const KnotVector& elevated, int j)
{
    const int p = knots.degree();
    const int span = knots.findSpan(elevated[j]);
    Mean mean{span - p, {}};
    for (int without = 1; without <= p + 1; ++without) {
        BasisRow row{1.0};
        for (int d = 1; d <= p; ++d)
            raiseDegree(knots, span, elevated[j + d + (d >= without ? 1 : 0)], d, row);
        for (size_t k = 0; k <= static_cast<size_t>(p); ++k)
            mean.shares[k] += row[k] / (p + 1);
    }
    return mean;
}

// Relative to the old point that counts most: equal points stay what they are, and so do corners.
template <class At>
ControlPoint blended(const Mean& mean, int degree, const At& at)
{
    const auto begin = mean.shares.begin();
    const auto heaviest = static_cast<int>(std::max_element(begin, begin + degree + 1) - begin);
    const ControlPoint& origin = at(mean.first + heaviest);
    double weight = origin.weight;
    Vec3 sum{0};
    for (int k = 0; k <= degree; ++k) {
        const double share = mean.shares[static_cast<size_t>(k)];
        if (share == 0 || k == heaviest)
            continue;
        const ControlPoint& point = at(mean.first + k);
        weight += share * (point.weight - origin.weight);
        sum += share * point.weight * (point.position - origin.position);
    }
    return {origin.position + sum / weight, weight};
}

NurbsSurface elevatedOnce(const NurbsSurface& surface, Direction direction)
{
    const KnotVector& knots = knotsAlong(surface, direction);
    KnotVector elevated = elevatedKnots(knots);
    std::vector<Mean> means;
    for (int j = 0; j < elevated.controlPointCount(); ++j)
        means.push_back(meanFor(knots, elevated, j));
    auto points = rowByRow(surface, direction, elevated.controlPointCount(), [&](const auto& at, int k) {
        return blended(means[static_cast<size_t>(k)], knots.degree(), at);
    });
    return withKnotsAlong(surface, direction, std::move(elevated), std::move(points));
}

}  // namespace

NurbsSurface withDegree(const NurbsSurface& surface, Direction direction, int degree)
{
    const KnotVector& knots = knotsAlong(surface, direction);
    check(degree >= knots.degree() && degree <= kMaxDegree, "a degree is raised, to at most the highest");
    if (degree == knots.degree())
        return surface;
    NurbsSurface result = clampedPart(surface, direction, knots.domainStart(), knots.domainEnd());
    while (knotsAlong(result, direction).degree() < degree)
        result = elevatedOnce(result, direction);
    return result;
}

}  // namespace knotspan
