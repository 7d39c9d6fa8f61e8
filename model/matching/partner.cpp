#include "model/matching/partner.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/geometry/degree_elevation.h"
#include "model/geometry/evaluation.h"
#include "model/geometry/orientation.h"
#include "model/matching/row_fit.h"

namespace knotspan {

namespace {

constexpr double kSameKnot = 1e-9;  // of the domain's length

Result<NurbsSurface> withKnotsOf(const NurbsSurface& surface, const KnotVector& along)
{
    std::vector<double> values = surface.knotsV().values();
    const double near = kSameKnot * (along.domainEnd() - along.domainStart());
    for (double& value : values) {
        const auto above = std::lower_bound(along.values().begin(), along.values().end(), value - near);
        if (above != along.values().end() && *above <= value + near)
            value = *above;
    }
    auto knots = KnotVector::create(surface.degreeV(), std::move(values));
    if (!knots)
        return failure("The knots along the two edges lie too close to each other",
                       "Remove knots along one of them");
    return NurbsSurface::create(surface.knotsU(), *std::move(knots), surface.controlPoints());
}

SurfacePoint edgePoint(const NurbsSurface& surface, double v)
{
    return evaluate(surface, surface.knotsU().domainStart(), v);
}

// Newton's method on the distance's derivative from the nearest of the points tried.
double nearestTo(const Vec3& point, const NurbsSurface& partner, const std::vector<double>& tries)
{
    double best = tries.front();
    double bestDistance = std::numeric_limits<double>::infinity();
    const auto attempt = [&](double v) {
        const double distance = glm::length(edgePoint(partner, v).position - point);
        if (distance < bestDistance) {
            best = v;
            bestDistance = distance;
        }
    };
    for (const double v : tries)
        attempt(v);
    for (int step = 0; step < 12; ++step) {
        const SurfacePoint at = edgePoint(partner, best);
        const Vec3 off = at.position - point;
        const double slope = glm::dot(at.dv, at.dv) + glm::dot(off, at.dvv);
        const double before = best;
        attempt(partner.knotsV().inDomain(best - glm::dot(off, at.dv) / slope));
        if (best == before)
            break;
    }
    return best;
}

}  // namespace

Result<NurbsSurface> partnerOf(const NurbsSurface& other, double from, double to, bool reversedEdge,
                               const KnotVector& along)
{
    const NurbsSurface part =
        clampedPart(other, Direction::V, other.knotsV().inDomain(from), other.knotsV().inDomain(to));
    auto mapped = withDomain(reversedEdge ? reversed(part, Direction::V) : part, Direction::V,
                             along.domainStart(), along.domainEnd());
    if (!mapped)
        return mapped;
    return withKnotsOf(*mapped, along);
}

std::vector<double> missingKnots(const KnotVector& have, const KnotVector& wanted)
{
    check(have.degree() == wanted.degree(), "knots of one degree are compared");
    std::vector<double> missing;
    const auto begin = wanted.values().begin() + wanted.degree() + 1;
    const auto end = wanted.values().begin() + wanted.controlPointCount();
    std::set_difference(begin, end, have.values().begin(), have.values().end(), std::back_inserter(missing));
    return missing;
}

SameEdgeKnots withSameEdgeKnots(const NurbsSurface& mover, const NurbsSurface& partner)
{
    const int degree = std::max(mover.degreeV(), partner.degreeV());
    SameEdgeKnots both{withDegree(mover, Direction::V, degree), withDegree(partner, Direction::V, degree)};
    const auto forMover = missingKnots(both.mover.knotsV(), both.partner.knotsV());
    const auto forPartner = missingKnots(both.partner.knotsV(), both.mover.knotsV());
    both.mover = withKnotsInserted(both.mover, Direction::V, forMover);
    both.partner = withKnotsInserted(both.partner, Direction::V, forPartner);
    return both;
}

Partnering sameParameter()
{
    return [](double v) { return v; };
}

Partnering nearestParameter(const NurbsSurface& mover, const NurbsSurface& partner)
{
    return [mover, partner, tries = sampleParameters(partner.knotsV(), 8)](double v) {
        return nearestTo(edgePoint(mover, v).position, partner, tries);
    };
}

double measuredGap(const NurbsSurface& mover, const NurbsSurface& partner, const Partnering& partnering,
                   int perSpan)
{
    double gap = 0;
    for (const double v : sampleParameters(mover.knotsV(), perSpan))
        gap = std::max(
            gap, glm::length(edgePoint(mover, v).position - edgePoint(partner, partnering(v)).position));
    return gap;
}

}  // namespace knotspan
