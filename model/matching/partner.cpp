#include "model/matching/partner.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <unordered_map>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/geometry/degree_elevation.h"
#include "model/geometry/evaluation.h"
#include "model/geometry/orientation.h"
#include "model/matching/edge_parameters.h"
#include "model/matching/row_fit.h"

namespace knotspan {

namespace {

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
                       "Move the other side instead");
    return NurbsSurface::create(surface.knotsU(), *std::move(knots), surface.controlPoints());
}

SurfacePoint edgePoint(const NurbsSurface& surface, double v)
{
    return evaluate(surface, surface.knotsU().domainStart(), v);
}

// Which parameters of the partner's edge are nearest to the mover's. The same are asked for many times over,
// and the next is mostly close to the one before.
class NearestOnEdge {
public:
    NearestOnEdge(const NurbsSurface& mover, const NurbsSurface& partner)
        : mover_(mover),
          partner_(partner),
          parameters_(sampleParameters(partner.knotsV(), 8)),
          last_(parameters_.front())
    {
        for (const double v : parameters_) {
            points_.push_back(edgePoint(partner, v).position);
            const double step = points_.size() < 2 ? 0 : glm::distance(points_.end()[-2], points_.back());
            ways_.push_back(ways_.empty() ? 0 : ways_.back() + step);
            longestStep_ = std::max(longestStep_, step);
        }
    }

    double at(double v)
    {
        const auto [known, isNew] = answers_.emplace(v, 0);
        if (isNew)
            known->second = last_ = nearest(edgePoint(mover_, v).position).v;
        return known->second;
    }

private:
    struct Place {
        double v = 0;
        double distance = 0;
    };

    // A sample is no nearer than another one less the way between the two, so most are passed over.
    [[nodiscard]] Place nearest(const Vec3& point) const
    {
        Place best = downhill(point, last_);
        for (size_t k = 0; k < points_.size();) {
            const double beside = distanceOf(k, point) - longestStep_;
            if (beside < best.distance && isValley(k, point)) {
                const Place found = downhill(point, parameters_[k]);
                if (found.distance < best.distance)
                    best = found;
            }
            const auto next = ways_.begin() + static_cast<std::ptrdiff_t>(k) + 1;
            const double way = ways_[k] + beside - best.distance;
            k = static_cast<size_t>(std::lower_bound(next, ways_.end(), way) - ways_.begin());
        }
        return best;
    }

    [[nodiscard]] double distanceOf(size_t k, const Vec3& point) const
    {
        return glm::distance(points_[k], point);
    }

    [[nodiscard]] bool isValley(size_t k, const Vec3& point) const
    {
        const double own = distanceOf(k, point);
        return (k == 0 || own <= distanceOf(k - 1, point)) &&
               (k + 1 == points_.size() || own <= distanceOf(k + 1, point));
    }

    // Gauss-Newton; a step that leads uphill is halved.
    [[nodiscard]] Place downhill(const Vec3& point, double v) const
    {
        SurfacePoint here = edgePoint(partner_, v);
        double distance = glm::distance(here.position, point);
        const double shortest = 1e-15 * (partner_.knotsV().domainEnd() - partner_.knotsV().domainStart());
        for (int step = 0; step < 24; ++step) {
            const double square = glm::dot(here.dv, here.dv);
            if (!(square > 0))
                break;
            double change =
                partner_.knotsV().inDomain(v - glm::dot(here.position - point, here.dv) / square) - v;
            bool isNearer = false;
            for (int half = 0; half < 6 && std::abs(change) > shortest && !isNearer; ++half, change /= 2) {
                const SurfacePoint there = edgePoint(partner_, v + change);
                isNearer = glm::distance(there.position, point) < distance;
                if (isNearer) {
                    v += change;
                    here = there;
                    distance = glm::distance(here.position, point);
                }
            }
            if (!isNearer)
                break;
        }
        return {v, distance};
    }

    NurbsSurface mover_;
    NurbsSurface partner_;
    std::vector<double> parameters_;
    std::vector<Vec3> points_;  // of the partner's edge at the parameters
    std::vector<double> ways_;  // along the polygon through them
    double longestStep_ = 0;
    double last_;  // answer
    std::unordered_map<double, double> answers_;
};

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
    return [search = std::make_shared<NearestOnEdge>(mover, partner)](double v) { return search->at(v); };
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
