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

// Axis z, from `base` up by `height`: u runs eastwards (8 spans), v upwards (degree 1, from 0 to 1). Open at
// both ends.
[[nodiscard]] NurbsSurface cylinder(const Vec3& base, double radius, double height);

// The same with two radii, of which one may be 0: there a whole row of control points coincides. Height 0
// with two radii is a flat ring or disc, whose normal points up where the lower radius is the greater one.
[[nodiscard]] NurbsSurface cone(const Vec3& base, double radiusBelow, double radiusAbove, double height);

// The parallelogram corner + u a + v b, degree 1, u and v from 0 to 1.
[[nodiscard]] NurbsSurface plane(const Vec3& corner, const Vec3& a, const Vec3& b);

}  // namespace knotspan
