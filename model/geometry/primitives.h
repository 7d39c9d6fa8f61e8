// Exact surfaces of simple shapes. Circles are made of rational quadratic arcs of 45 degrees, eight round,
// with double knots at 0, 1, ..., 8. Normals (S_u x S_v) point outwards.
#pragma once

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

// Around `centre`, axis z: u runs eastwards (8 spans), v from the south pole to the north pole (4 spans). At
// the poles a whole row of control points coincides.
[[nodiscard]] NurbsSurface sphere(const Vec3& centre, double radius);

// Around `centre`, axis z: u runs round the axis, v round the tube (8 spans each). 0 < minor < major.
[[nodiscard]] NurbsSurface torus(const Vec3& centre, double major, double minor);

// The parallelogram corner + u a + v b, degree 1, u and v from 0 to 1.
[[nodiscard]] NurbsSurface plane(const Vec3& corner, const Vec3& a, const Vec3& b);

}  // namespace knotspan
