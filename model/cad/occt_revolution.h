// Surfaces swept by a curve: revolutions and extrusions, as the exact rational nets they are.
#pragma once

#include <vector>

#include <Geom_Curve.hxx>
#include <gp_Ax1.hxx>
#include <gp_Vec.hxx>

#include "model/cad/occt_surface.h"

namespace knotspan::occt {

// A curve as knots and control points, and where its parameters went.
struct ConvertedCurve {
    int degree = 1;
    std::vector<double> knots;
    std::vector<ControlPoint> points;
    ParameterMap map;
    bool approximated = false;
};

// `curve` between two parameters: lines, circles, ellipses, Bezier and B-spline curves exactly.
[[nodiscard]] ConvertedCurve toNurbs(const Handle(Geom_Curve) & curve, double start, double end);

// Arcs of equal length that together turn by `angle`: as many as OpenCASCADE would take, so that counts
// agree.
[[nodiscard]] int arcSpans(double angle);

// u turns from `startAngle` to `endAngle` around the axis, v runs along the meridian (which lies at angle 0).
[[nodiscard]] Result<ConvertedSurface> revolved(const ConvertedCurve& meridian, const gp_Ax1& axis,
                                                double startAngle, double endAngle);

// u runs along the curve, v from `startV` to `endV` along the direction.
[[nodiscard]] Result<ConvertedSurface> extruded(const ConvertedCurve& curve, const gp_Vec& direction,
                                                double startV, double endV);

}  // namespace knotspan::occt
