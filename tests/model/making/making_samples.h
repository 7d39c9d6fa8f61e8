// Random but repeatable curves and placements, and how far a point is from what a formula says.
#pragma once

#include "model/geometry/nurbs_curve.h"
#include "model/making/placement.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

[[nodiscard]] Vec3 randomVector(std::mt19937& random, double size);  // coordinates within -size .. size
[[nodiscard]] double randomIn(std::mt19937& random, const KnotVector& knots);

struct RandomCurveShape {
    int degree = 3;
    int spans = 3;
    double weightRatio = 1;  // above 1: rational
    bool clamped = true;
    Vec3 offset{0};
};
// About `spans` long along x.
[[nodiscard]] NurbsCurve randomCurve(std::mt19937& random, const RandomCurveShape& shape);

// The origin within `far` of the model's; axis and direction of any length.
[[nodiscard]] Placement randomPlacement(std::mt19937& random, double far);

// A circle round z at `height`, full, of rational quadratic arcs.
[[nodiscard]] NurbsCurve circleAt(double height, double radius);

// The straight line from a to b, over 0 .. 1.
[[nodiscard]] NurbsCurve lineFrom(const Vec3& a, const Vec3& b);

// Of all coordinates: what rounding is relative to.
[[nodiscard]] double reachOf(const Box& box);

}  // namespace knotspan::testing
