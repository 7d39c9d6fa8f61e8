// Rational Bézier curves against each other and against points, decided from their coefficients. Curves are
// nets with degreeV = 0, weights above zero.
#pragma once

#include "model/geometry/bezier_conversion.h"

namespace knotspan {

[[nodiscard]] inline Vec3 pointOf(const Vec4& homogeneous)
{
    return Vec3(homogeneous) / homogeneous.w;
}

// The box around the control points, the curve inside it.
[[nodiscard]] Box boundsOf(const BezierNet& curve);

// The same curve with one control point more (The NURBS Book, 5.5), until it has that degree.
[[nodiscard]] BezierNet elevated(const BezierNet& curve, int degree);

// The part between two parameters; start > end: run through the other way.
[[nodiscard]] BezierNet part(const BezierNet& curve, double start, double end);

// Whether both are one curve with one parameter, to `tolerance`: elevated to one degree, their control points
// are no further apart and their weights are equal, up to one factor for all, to 1e-6.
[[nodiscard]] bool sameCurve(const BezierNet& a, const BezierNet& b, double tolerance);

// Where the curve comes nearest to a point, within `tolerance` of it: parameters, increasing, at least 1/1024
// apart.
[[nodiscard]] std::vector<double> parametersAt(const BezierNet& curve, const Vec3& point, double tolerance);

}  // namespace knotspan
