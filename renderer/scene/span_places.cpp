#include "renderer/scene/span_places.h"

#include <array>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

// Gauss and Legendre's places and weights on [0, 1].
constexpr std::array<std::array<double, 2>, 3> kGauss = {
    {{0.11270166537925831, 5.0 / 18}, {0.5, 8.0 / 18}, {0.88729833462074169, 5.0 / 18}}};
constexpr std::array<double, 3> kLines = {1.0 / 6, 0.5, 5.0 / 6};  // of the other parameter's domain

double at(const KnotVector& knots, double share)
{
    return knots.domainStart() + share * (knots.domainEnd() - knots.domainStart());
}

// Of one span of `along`, the mean over some lines that run along it.
double lengthOf(const SceneObject& object, bool alongU, int span)
{
    const NurbsSurface& surface = object.surface;
    const glm::dmat3 turn(object.transform);
    const KnotVector& along = alongU ? surface.knotsU() : surface.knotsV();
    const KnotVector& across = alongU ? surface.knotsV() : surface.knotsU();
    const double size = along[span + 1] - along[span];
    double sum = 0;
    for (const double line : kLines)
        for (const auto& [place, weight] : kGauss) {
            const double t = along[span] + place * size;
            const double other = at(across, line);
            const SurfacePoint point = evaluate(surface, alongU ? t : other, alongU ? other : t);
            sum += weight * size * glm::length(turn * (alongU ? point.du : point.dv));
        }
    return sum / static_cast<double>(kLines.size());
}

std::vector<float> placesOf(const SceneObject& object, CheckerBy by)
{
    std::vector<float> places;
    for (const bool alongU : {true, false}) {
        const KnotVector& knots = alongU ? object.surface.knotsU() : object.surface.knotsV();
        const double size = knots.domainEnd() - knots.domainStart();
        double length = 0;
        for (const int span : knots.spans()) {
            const bool byLength = by == CheckerBy::length;
            places.push_back(
                static_cast<float>(byLength ? length : (knots[span] - knots.domainStart()) / size));
            if (byLength)
                length += lengthOf(object, alongU, span);
        }
        places.push_back(static_cast<float>(by == CheckerBy::length ? length : 1));
    }
    return places;
}

}  // namespace

const std::vector<float>& SpanPlaces::of(const std::vector<Resident>& residents, CheckerBy by,
                                         const ResidentChanges* log)
{
    const HeldResidents::Difference difference = held_.take(residents, log);
    if (difference.anew || by_ != by) {
        by_ = by;
        places_.clear();
        for (const Resident& resident : residents) {
            const std::vector<float> places = placesOf(*resident.object, by);
            places_.insert(places_.end(), places.begin(), places.end());
        }
        return places_;
    }
    for (const SurfaceChange& change : difference.changes) {
        const std::vector<float> places = placesOf(*residents[change.index].object, by);
        const size_t first = residents[change.index].firstBorder / 2 + 2 * size_t{change.index};
        std::copy(places.begin(), places.end(), places_.begin() + static_cast<std::ptrdiff_t>(first));
    }
    return places_;
}

}  // namespace knotspan
