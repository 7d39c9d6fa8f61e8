#include "model/refining/refinements.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/geometry/degree_elevation.h"
#include "model/refining/directions.h"
#include "model/refining/spline_fit.h"

namespace knotspan {

namespace {

std::string text(double value)
{
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.4g", value);
    return buffer;
}

bool isInside(const KnotVector& knots, double value)
{
    return value > knots.domainStart() && value < knots.domainEnd();
}

Result<void> requireInside(const KnotVector& knots, double value)
{
    if (!isInside(knots, value))
        return failure(text(value) + " is not inside the surface's domain",
                       "Choose a parameter between " + text(knots.domainStart()) + " and " +
                           text(knots.domainEnd()));
    return {};
}

Refinement refined(NurbsSurface surface, const NurbsSurface& before)
{
    const Deviation deviation = deviationOf(surface, before);
    return {std::move(surface), deviation};
}

Result<Refinement> withinTolerance(Result<NurbsSurface> surface, const NurbsSurface& before, double tolerance)
{
    if (!surface)
        return tl::unexpected(surface.error());
    Refinement result = refined(*std::move(surface), before);
    if (!(result.deviation.bound <= tolerance))
        return failure("The surface would move by up to " + text(result.deviation.bound) +
                           ", more than the " + text(tolerance) + " allowed",
                       "Allow more, or leave it as it is");
    return result;
}

// Interior knots, each as often as it stands there, between clamped ends.
Result<KnotVector> clampedKnots(int degree, const KnotVector& domain, const std::vector<double>& inside)
{
    std::vector<double> knots(static_cast<size_t>(degree + 1), domain.domainStart());
    knots.insert(knots.end(), inside.begin(), inside.end());
    knots.insert(knots.end(), static_cast<size_t>(degree + 1), domain.domainEnd());
    return KnotVector::create(degree, std::move(knots));
}

std::vector<double> knotsInside(const KnotVector& knots)
{
    std::vector<double> result;
    for (const double knot : knots.values())
        if (isInside(knots, knot))
            result.push_back(knot);
    return result;
}

}  // namespace

Result<Refinement> insertKnot(const NurbsSurface& surface, Direction direction, double value)
{
    const KnotVector& knots = knotsOf(surface, direction);
    if (auto inside = requireInside(knots, value); !inside)
        return tl::unexpected(inside.error());
    if (std::count(knots.values().begin(), knots.values().end(), value) >= knots.degree())
        return failure("The knot " + text(value) + " stands there as often as the degree already",
                       "Choose another parameter, or raise the degree first");
    return refined(withKnotInserted(surface, direction, value), surface);
}

Result<Refinement> removeKnot(const NurbsSurface& surface, Direction direction, double value,
                              double tolerance)
{
    const KnotVector& knots = knotsOf(surface, direction);
    std::vector<double> inside = knotsInside(knots);
    if (inside.empty())
        return failure("There is no knot inside the surface in this direction", "Choose the other direction");
    const auto nearest = std::min_element(inside.begin(), inside.end(), [&](double a, double b) {
        return std::abs(a - value) < std::abs(b - value);
    });
    inside.erase(nearest);
    const auto fewer = clampedKnots(knots.degree(), knots, inside);
    if (!fewer)
        return tl::unexpected(fewer.error());
    return withinTolerance(fittedTo(surface, direction, *fewer), surface, tolerance);
}

Result<Refinement> raiseDegree(const NurbsSurface& surface, Direction direction)
{
    const int degree = knotsOf(surface, direction).degree();
    if (degree >= kMaxDegree)
        return failure("The degree is " + std::to_string(degree) + ", the highest there is",
                       "Insert knots instead");
    return refined(withDegree(surface, direction, degree + 1), surface);
}

Result<Refinement> lowerDegree(const NurbsSurface& surface, Direction direction, double tolerance)
{
    const KnotVector& knots = knotsOf(surface, direction);
    if (knots.degree() <= kMinDegree)
        return failure("The degree is 1, the lowest there is", "Remove knots instead");
    const std::vector<double> inside = knotsInside(knots);
    std::vector<double> fewer;
    for (size_t k = 1; k < inside.size(); ++k)
        if (inside[k] == inside[k - 1])
            fewer.push_back(inside[k]);
    const auto lower = clampedKnots(knots.degree() - 1, knots, fewer);
    if (!lower)
        return tl::unexpected(lower.error());
    return withinTolerance(fittedTo(surface, direction, *lower), surface, tolerance);
}

Result<Refinement> rebuild(const NurbsSurface& surface, const NetShape& shape)
{
    NurbsSurface result = surface;
    for (const Direction direction : {Direction::U, Direction::V}) {
        const bool byU = direction == Direction::U;
        const int degree = byU ? shape.degreeU : shape.degreeV;
        const int count = byU ? shape.countU : shape.countV;
        if (degree < kMinDegree || degree > kMaxDegree)
            return failure("A degree is from 1 to " + std::to_string(kMaxDegree), "Choose another one");
        if (count <= degree)
            return failure("Degree " + std::to_string(degree) + " needs at least " +
                               std::to_string(degree + 1) + " control points in its direction",
                           "Ask for more of them, or for a lower degree");
        const KnotVector& knots = knotsOf(surface, direction);
        std::vector<double> inside;
        const int spans = count - degree;
        for (int k = 1; k < spans; ++k)
            inside.push_back(knots.domainStart() + (knots.domainEnd() - knots.domainStart()) * k / spans);
        const auto even = clampedKnots(degree, knots, inside);
        if (!even)
            return tl::unexpected(even.error());
        auto next = fittedTo(result, direction, *even);
        if (!next)
            return tl::unexpected(next.error());
        result = *std::move(next);
    }
    return refined(std::move(result), surface);
}

Result<std::pair<NurbsSurface, NurbsSurface>> splitAt(const NurbsSurface& surface, Direction direction,
                                                      double value)
{
    const KnotVector& knots = knotsOf(surface, direction);
    if (auto inside = requireInside(knots, value); !inside)
        return tl::unexpected(inside.error());
    // First so many knots that the cut is a row of control points, which both parts then have to the bit.
    const auto there = std::count(knots.values().begin(), knots.values().end(), value);
    const NurbsSurface cut =
        withKnotInserted(surface, direction, value, knots.degree() - static_cast<int>(there));
    return std::pair(clampedPart(cut, direction, knots.domainStart(), value),
                     clampedPart(cut, direction, value, knots.domainEnd()));
}

}  // namespace knotspan
