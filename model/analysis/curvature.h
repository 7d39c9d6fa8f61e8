// How a surface bends at a point.
#pragma once

#include <optional>

#include "model/geometry/evaluation.h"

namespace knotspan {

// In 1 per model unit; positive where the surface bends towards its normal S_u x S_v. largest >= smallest.
struct Curvature {
    double gauss = 0;
    double mean = 0;
    double largest = 0;
    double smallest = 0;
};

// One of those figures.
enum class CurvatureKind : int { mean, gauss, largest, smallest };
[[nodiscard]] double figure(const Curvature& curvature, CurvatureKind kind);

// From the first and second fundamental forms (do Carmo, 3.3). Nothing where S_u x S_v vanishes or a figure
// would not be finite.
[[nodiscard]] std::optional<Curvature> curvature(const SurfacePoint& point);

// Unit, perpendicular to each other and to the normal; which of a direction's two ways means nothing.
struct PrincipalDirections {
    Vec3 largest{0};   // that the surface has its largest curvature along
    Vec3 smallest{0};  // and its smallest
};

// Nothing where there is no curvature, nor at umbilics, where both are the same to about ten digits: every
// direction is a principal one there.
[[nodiscard]] std::optional<PrincipalDirections> principalDirections(const SurfacePoint& point);

}  // namespace knotspan
