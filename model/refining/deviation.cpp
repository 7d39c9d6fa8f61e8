#include "model/refining/deviation.h"

#include <algorithm>
#include <map>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/geometry/degree_elevation.h"
#include "model/geometry/evaluation.h"
#include "model/geometry/knot_insertion.h"
#include "model/geometry/ksquad.h"
#include "model/refining/directions.h"

namespace knotspan {

namespace {

std::map<double, int> countsInside(const KnotVector& knots)
{
    std::map<double, int> counts;
    for (const double knot : knots.values())
        if (knot > knots.domainStart() && knot < knots.domainEnd())
            ++counts[knot];
    return counts;
}

// Those that `own` lacks of `wanted`.
std::vector<double> missing(const std::map<double, int>& wanted, const std::map<double, int>& own)
{
    std::vector<double> result;
    for (const auto& [knot, count] : wanted) {
        const auto found = own.find(knot);
        const int has = found == own.end() ? 0 : found->second;
        result.insert(result.end(), static_cast<size_t>(std::max(0, count - has)), knot);
    }
    return result;
}

// Both with one degree and all knots of both, each span in quarters.
void makeAlike(NurbsSurface& a, NurbsSurface& b, Direction direction)
{
    const int degree = std::max(knotsOf(a, direction).degree(), knotsOf(b, direction).degree());
    const double start = knotsOf(a, direction).domainStart();
    const double end = knotsOf(a, direction).domainEnd();
    for (NurbsSurface* const surface : {&a, &b})
        *surface = withDegree(clampedPart(*surface, direction, start, end), direction, degree);
    std::map<double, int> all = countsInside(knotsOf(a, direction));
    for (const auto& [knot, count] : countsInside(knotsOf(b, direction)))
        all[knot] = std::max(all[knot], count);
    std::vector<double> places{start};
    for (const auto& [knot, count] : all)
        places.push_back(knot);
    places.push_back(end);
    for (size_t k = 0; k + 1 < places.size(); ++k)
        for (const double share : {0.25, 0.5, 0.75}) {
            const double knot = places[k] + share * (places[k + 1] - places[k]);
            if (knot > places[k] && knot < places[k + 1])
                all[knot] = 1;
        }
    for (NurbsSurface* const surface : {&a, &b})
        *surface =
            withKnotsInserted(*surface, direction, missing(all, countsInside(knotsOf(*surface, direction))));
}

// Over one KSQuad, from the control points that shape it.
double boundOn(const KsQuad& quad, const NurbsSurface& a, const NurbsSurface& b)
{
    Box box;
    const auto each = [&](const auto& visit) {
        for (int i = quad.spanU - a.degreeU(); i <= quad.spanU; ++i)
            for (int j = quad.spanV - a.degreeV(); j <= quad.spanV; ++j)
                visit(a.controlPoint(i, j), b.controlPoint(i, j));
    };
    each([&](const ControlPoint&, const ControlPoint& q) { box.add(q.position); });
    const Vec3 centre = box.centre();
    double lightest = std::numeric_limits<double>::infinity();
    double away = 0;
    each([&](const ControlPoint& p, const ControlPoint& q) {
        lightest = std::min(lightest, p.weight);
        // S_a - S_b = sum N (w p - w' q - (w - w') S_b) / sum N w, and S_b is inside the box.
        away =
            std::max(away, glm::length(p.weight * (p.position - centre) - q.weight * (q.position - centre)) +
                               box.diagonal() / 2 * std::abs(p.weight - q.weight));
    });
    return away / lightest;
}

// Both have one degree and the same knots.
double boundOf(const NurbsSurface& a, const NurbsSurface& b)
{
    double bound = 0;
    for (const KsQuad& quad : ksQuads(a))
        bound = std::max(bound, boundOn(quad, a, b));
    return bound;
}

double measuredBetween(const NurbsSurface& a, const NurbsSurface& b)
{
    constexpr int kSteps = 6;  // a span of `a`, whose knots are those of both
    const auto placesOf = [](const KnotVector& knots) {
        std::vector<double> places;
        for (const int span : knots.spans())
            for (int k = 0; k < kSteps; ++k)
                places.push_back(knots[span] + (knots[span + 1] - knots[span]) * k / kSteps);
        places.push_back(knots.domainEnd());
        return places;
    };
    double largest = 0;
    const std::vector<double> alongV = placesOf(a.knotsV());
    for (const double u : placesOf(a.knotsU()))
        for (const double v : alongV)
            largest =
                std::max(largest, glm::distance(evaluate(a, u, v).position, evaluate(b, u, v).position));
    return largest;
}

}  // namespace

Deviation deviationOf(const NurbsSurface& a, const NurbsSurface& b)
{
    for (const Direction direction : {Direction::U, Direction::V})
        check(knotsOf(a, direction).domainStart() == knotsOf(b, direction).domainStart() &&
                  knotsOf(a, direction).domainEnd() == knotsOf(b, direction).domainEnd(),
              "surfaces that are compared have one domain");
    NurbsSurface fineA = a;
    NurbsSurface fineB = b;
    for (const Direction direction : {Direction::U, Direction::V})
        makeAlike(fineA, fineB, direction);
    const double measured = measuredBetween(a.controlPoints().size() > b.controlPoints().size() ? a : b,
                                            a.controlPoints().size() > b.controlPoints().size() ? b : a);
    return {measured, std::max(measured, boundOf(fineA, fineB))};
}

}  // namespace knotspan
