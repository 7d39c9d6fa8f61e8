// A NURBS curve in space: immutable, and always a valid one. What surfaces are made from, and what is taken
// from them.
#pragma once

#include <vector>

#include "model/geometry/knot_insertion.h"

namespace knotspan {

class NurbsCurve {
public:
    // Refuses, with a sentence that names the control point: a number of them that is not the knots';
    // coordinates that are not finite; weights that are not finite or not above zero. All points may
    // coincide: such a curve is the pole of a surface.
    [[nodiscard]] static Result<NurbsCurve> create(KnotVector knots, std::vector<ControlPoint> controlPoints);

    [[nodiscard]] const KnotVector& knots() const { return knots_; }
    [[nodiscard]] int degree() const { return knots_.degree(); }
    [[nodiscard]] const std::vector<ControlPoint>& controlPoints() const { return controlPoints_; }
    // The box around the control points; the curve lies inside it.
    [[nodiscard]] const Box& bounds() const { return bounds_; }

    [[nodiscard]] bool operator==(const NurbsCurve& other) const
    {
        return knots_ == other.knots_ && controlPoints_ == other.controlPoints_;
    }

private:
    NurbsCurve(KnotVector knots, std::vector<ControlPoint> controlPoints);

    KnotVector knots_;
    std::vector<ControlPoint> controlPoints_;
    Box bounds_;
};

// The point at t, taken into the domain (NaN to its start).
[[nodiscard]] Vec3 evaluate(const NurbsCurve& curve, double t);

// The curve on which `across` has the value `parameter`, exactly (the row of control points that
// withKnotInserted() would bring onto the surface): across U it runs along v, with the surface's knots of v.
// Refuses, with a sentence, a parameter outside the domain.
[[nodiscard]] Result<NurbsCurve> isoCurve(const NurbsSurface& surface, Direction across, double parameter);

// Run the other way round: the parameter becomes its negative, the domain [a, b] becomes [-b, -a]. Exact.
[[nodiscard]] NurbsCurve reversed(const NurbsCurve& curve);

// Each control point moved by an affine map. Fails, with a sentence, where that is not finite.
[[nodiscard]] Result<NurbsCurve> transformed(const NurbsCurve& curve, const Mat4& transform);

}  // namespace knotspan
