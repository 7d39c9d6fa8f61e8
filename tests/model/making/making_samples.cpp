#include "tests/model/making/making_samples.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/arcs.h"

namespace knotspan::testing {

Vec3 randomVector(std::mt19937& random, double size)
{
    const double x = randomBetween(random, -size, size);
    const double y = randomBetween(random, -size, size);
    return {x, y, randomBetween(random, -size, size)};
}

double randomIn(std::mt19937& random, const KnotVector& knots)
{
    return randomBetween(random, knots.domainStart(), knots.domainEnd());
}

NurbsCurve randomCurve(std::mt19937& random, const RandomCurveShape& shape)
{
    KnotVector knots = randomKnots(random, shape.degree, shape.spans, 4, shape.clamped);
    std::vector<ControlPoint> points;
    for (int k = 0; k < knots.controlPointCount(); ++k)
        points.push_back({shape.offset +
                              Vec3(k * static_cast<double>(shape.spans) / knots.controlPointCount(), 0, 0) +
                              randomVector(random, 0.4),
                          std::pow(shape.weightRatio, randomBetween(random, -1, 1))});
    return NurbsCurve::create(std::move(knots), std::move(points)).value();
}

Placement randomPlacement(std::mt19937& random, double far)
{
    Placement placement{randomVector(random, far), randomVector(random, 1), randomVector(random, 1)};
    placement.axis *= std::pow(10, randomBetween(random, -8, 8));
    placement.direction *= std::pow(10, randomBetween(random, -8, 8));
    return placement;
}

NurbsCurve circleAt(double height, double radius)
{
    std::vector<ControlPoint> points;
    for (const ArcPoint& point : arcPoints(360))
        points.push_back({{radius * point.x, radius * point.y, height}, point.weight});
    return NurbsCurve::create(arcKnots(8), std::move(points)).value();
}

NurbsCurve lineFrom(const Vec3& a, const Vec3& b)
{
    return NurbsCurve::create(KnotVector::clampedUniform(1, 1), {{a, 1}, {b, 1}}).value();
}

double reachOf(const Box& box)
{
    return box.diagonal() + glm::length(box.centre());
}

}  // namespace knotspan::testing
