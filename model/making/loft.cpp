#include "model/making/loft.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "model/core/check.h"
#include "model/making/compatible_curves.h"
#include "model/making/numbers.h"
#include "model/making/row_interpolation.h"

namespace knotspan {

namespace {

Result<void> requireCurves(const std::vector<NurbsCurve>& curves, LoftEnds ends)
{
    const size_t fewest = ends == LoftEnds::closed ? 3 : 2;
    if (curves.size() < fewest)
        return failure(ends == LoftEnds::closed ? "A closed loft needs at least three curves"
                                                : "A loft needs at least two curves",
                       "Choose more curves");
    if (curves.size() > 1000)
        return failure("A loft goes through at most 1000 curves", "Choose fewer curves");
    for (size_t k = 0; k < curves.size(); ++k)
        for (const Vec3& corner : {curves[k].bounds().low, curves[k].bounds().high})
            if (auto place = requirePlace("Curve " + std::to_string(k + 1), corner); !place)
                return place;
    return {};
}

// From 0 to 1: for each row of control points its distances in parts of their sum, and of those the mean. The
// NURBS Book, 10.8. Nothing where neighbours fall together. `order`: curve after curve, the first again at
// the end where the loft closes.
std::vector<double> parametersAcross(const std::vector<const NurbsCurve*>& order)
{
    std::vector<double> steps(order.size() - 1, 0.0);
    for (size_t i = 0; i < order.front()->controlPoints().size(); ++i) {
        std::vector<double> distances;
        double sum = 0;
        for (size_t k = 1; k < order.size(); ++k) {
            distances.push_back(glm::distance(order[k]->controlPoints()[i].position,
                                              order[k - 1]->controlPoints()[i].position));
            sum += distances.back();
        }
        if (sum > 0)
            for (size_t k = 0; k < steps.size(); ++k)
                steps[k] += distances[k] / sum;
    }
    double whole = 0;
    for (const double step : steps)
        whole += step;
    std::vector<double> parameters{0};
    for (const double step : steps) {
        if (!(step > 1e-9 * whole))
            return {};
        parameters.push_back(parameters.back() + step / whole);
    }
    parameters.back() = 1;
    return parameters;
}

// Homogeneous, relative to `centre`, the first weight 1.
NumberRow numbersOf(const NurbsCurve& curve, const Vec3& centre)
{
    const double scale = curve.controlPoints().front().weight;
    NumberRow numbers;
    for (const ControlPoint& point : curve.controlPoints()) {
        const double weight = point.weight / scale;
        const Vec3 weighted = weight * (point.position - centre);
        numbers.insert(numbers.end(), {weighted.x, weighted.y, weighted.z, weight});
    }
    return numbers;
}

Result<NurbsSurface> surfaceOf(const KnotVector& along, const RowSpline& across, const Vec3& centre)
{
    std::vector<ControlPoint> points;
    for (size_t i = 0; i < static_cast<size_t>(along.controlPointCount()); ++i)
        for (const NumberRow& row : across.rows) {
            const double weight = row[4 * i + 3];
            if (!(weight > 0))
                return failure(
                    "The curves' weights are so different that no surface leads smoothly through them",
                    "Loft fewer of them at a time, or make their weights more alike");
            points.push_back({centre + Vec3(row[4 * i], row[4 * i + 1], row[4 * i + 2]) / weight, weight});
        }
    return NurbsSurface::create(along, across.knots, std::move(points));
}

// The row of control points at `row` (an end) made the curve itself, which the way through homogeneous
// coordinates rounded.
void restore(std::vector<ControlPoint>& points, size_t countV, size_t row, const NurbsCurve& curve)
{
    const double scale = curve.controlPoints().front().weight;
    for (size_t i = 0; i < curve.controlPoints().size(); ++i) {
        const ControlPoint& point = curve.controlPoints()[i];
        points[i * countV + row] = {point.position, point.weight / scale};
    }
}

}  // namespace

Result<Loft> lofted(const std::vector<NurbsCurve>& curves, LoftEnds ends)
{
    if (auto valid = requireCurves(curves, ends); !valid)
        return tl::unexpected(valid.error());
    const auto rows = compatibleCurves(curves);
    if (!rows)
        return tl::unexpected(rows.error());
    const bool closed = ends == LoftEnds::closed;
    std::vector<const NurbsCurve*> order;
    Box box;
    for (const NurbsCurve& row : *rows) {
        order.push_back(&row);
        box.add(row.bounds());
    }
    if (closed)
        order.push_back(order.front());
    std::vector<double> parameters = parametersAcross(order);
    if (parameters.empty())
        return failure("Two neighbouring curves lie at the same place", "Leave one of them out");

    std::vector<NumberRow> numbers;
    for (const NurbsCurve& row : *rows)
        numbers.push_back(numbersOf(row, box.centre()));
    const auto across =
        closed ? periodicSplineThrough(parameters, numbers) : splineThrough(parameters, numbers);
    if (!across)
        return failure("The curves lie too unevenly for a surface through them",
                       "Leave out some of those that lie close together");
    auto surface = surfaceOf(rows->front().knots(), *across, box.centre());
    if (!surface)
        return tl::unexpected(surface.error());
    if (closed)
        surface = clampedPart(*surface, Direction::V, 0, 1);

    std::vector<ControlPoint> points = surface->controlPoints();
    const auto countV = static_cast<size_t>(surface->countV());
    restore(points, countV, 0, *order.front());
    restore(points, countV, countV - 1, *order.back());
    surface = NurbsSurface::create(surface->knotsU(), surface->knotsV(), std::move(points));
    check(surface.has_value(), "the given curves are valid rows");
    return Loft{*std::move(surface), std::move(parameters)};
}

}  // namespace knotspan
