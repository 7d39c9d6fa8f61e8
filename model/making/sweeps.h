// Surfaces that a curve sweeps: along a vector, or round an axis. Exact: every place of the curve is on them.
#pragma once

#include "model/geometry/nurbs_curve.h"

namespace knotspan {

// u runs along the curve, with its knots; v along `vector`, degree 1, from 0 to 1. The curve itself is v = 0.
// Refuses, with a sentence, a vector that is not finite, zero or lost in the rounding of coordinates, and a
// curve that is a point or a straight line along the vector. The NURBS Book, 8.3.
[[nodiscard]] Result<NurbsSurface> extruded(const NurbsCurve& curve, const Vec3& vector);

struct RevolvingAxis {
    Vec3 point{0};
    Vec3 direction{0, 0, 1};  // of any length
};
// u runs round the axis, by the right hand where `degrees` is above zero, in arcs of at most 45 degrees with
// double knots at 0, 1, ...; v along the curve, with its knots. The curve itself is u = 0; after 360 degrees
// the surface ends there, to the bit. Normals point away from the axis where, at positive degrees, the curve
// runs the way the axis points. An end of the curve that touches the axis (to 1e-13 of its distances from
// the axis' point) is put on it and becomes a pole: a whole row of control points coincides.
// Refuses, with a sentence, numbers that are not finite, an axis of no length, angles of less than a
// millionth of a degree or more than 360 either way, and a curve that lies on the axis. The NURBS Book, A8.1.
[[nodiscard]] Result<NurbsSurface> revolved(const NurbsCurve& curve, const RevolvingAxis& axis,
                                            double degrees);

}  // namespace knotspan
