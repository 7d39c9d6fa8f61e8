// What can be measured at a place of a surface as it stands in a model, and between such places.
#pragma once

#include <optional>

#include "model/analysis/curvature.h"

namespace knotspan {

// The point and its derivatives in model space, of an object placed by an affine transform.
[[nodiscard]] SurfacePoint placed(const SurfacePoint& point, const Mat4& transform);

// All in model space, so of the surface as it is after its transform. The front is where S_u x S_v points in
// the surface's own coordinates: a mirror takes it along.
struct PlaceMeasures {
    Vec3 position{0};
    std::optional<Vec3> normal;          // unit, to the front; none where the surface has no tangent plane
    std::optional<Curvature> curvature;  // positive where the surface bends towards its front
    std::optional<PrincipalDirections> directions;
};

// At (u, v), which evaluate() takes into the domain.
[[nodiscard]] PlaceMeasures measuresAt(const NurbsSurface& surface, const Mat4& transform, double u,
                                       double v);

// From one place to another.
struct Separation {
    double distance = 0;  // the straight line's length
    Vec3 difference{0};
    std::optional<double> normalsDeg;  // 0 .. 180; none where one of the places has no normal
};
[[nodiscard]] Separation separation(const PlaceMeasures& from, const PlaceMeasures& to);

// 0 .. 180; nothing where one of them is zero.
[[nodiscard]] std::optional<double> angleDeg(const Vec3& a, const Vec3& b);
// Between the straight lines from `middle` to the two others.
[[nodiscard]] std::optional<double> angleAtDeg(const Vec3& middle, const Vec3& one, const Vec3& other);

}  // namespace knotspan
