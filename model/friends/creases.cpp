#include "model/friends/creases.h"

#include "model/geometry/knot_insertion.h"

namespace knotspan {

namespace {

// Knots inside that stand as often as the degree.
std::vector<double> fullKnots(const KnotVector& knots)
{
    std::vector<double> result;
    const std::vector<double>& values = knots.values();
    const auto degree = static_cast<size_t>(knots.degree());
    for (size_t k = 0; k + degree <= values.size(); ++k)
        if (values[k] > knots.domainStart() && values[k] < knots.domainEnd() &&
            values[k] == values[k + degree - 1])
            result.push_back(values[k]);
    return result;
}

}  // namespace

std::vector<Crease> creasesOf(const PlacedSurface& placed, const FriendTolerances& tolerances)
{
    std::vector<Crease> creases;
    for (const Direction across : {Direction::U, Direction::V}) {
        const bool byU = across == Direction::U;
        const KnotVector& knots = byU ? placed.surface->knotsU() : placed.surface->knotsV();
        double before = knots.domainStart();
        std::vector<double> cuts = fullKnots(knots);
        cuts.push_back(knots.domainEnd());
        for (size_t k = 0; k + 1 < cuts.size(); ++k) {
            const NurbsSurface a = clampedPart(*placed.surface, across, before, cuts[k]);
            const NurbsSurface b = clampedPart(*placed.surface, across, cuts[k], cuts[k + 1]);
            const Friends friends({{&a, placed.transform}, {&b, placed.transform}}, tolerances);
            double angle = -1;
            for (const FriendEdge& edge : friends.edges())
                if (edge.a.surface == 0 && edge.b.surface == 1 &&
                    edge.a.side == (byU ? Side::endU : Side::endV) &&
                    edge.b.side == (byU ? Side::startU : Side::startV) && edge.continuity == Continuity::g0)
                    angle = std::max(angle, edge.angleMaxDeg);
            if (angle >= 0)
                creases.push_back({across, cuts[k], angle});
            before = cuts[k];
        }
    }
    return creases;
}

}  // namespace knotspan
