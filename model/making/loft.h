// A smooth surface through a row of curves (skinning).
#pragma once

#include "model/geometry/nurbs_curve.h"

namespace knotspan {

enum class LoftEnds { open, closed };

struct Loft {
    NurbsSurface surface;
    std::vector<double> parameters;  // curve k is the iso-curve at v = parameters[k]; closed: one more, 1
};

// u runs along the curves, over the domain of the first; v across them, from 0 to 1, spaced by the mean
// distance of their control points (The NURBS Book, 10.8). Open: at least two curves, degree min(3, number -
// 1) across. Closed: at least three, degree 3, as smooth where it closes as elsewhere (C2), clamped, its last
// row the first to the bit. At most 1000 curves.
//
// Each curve is an iso-curve of the surface, place for place of their (affinely mapped) parameters: they get
// one degree and one set of knots (compatible_curves.h), and homogeneous control points are interpolated,
// each curve's weights first divided by that of its first control point. Curves are taken as they run:
// reversed() turns one that runs against the others.
//
// Refuses, with a sentence: too few or too many curves; neighbours that are the same; weights so different
// that the surface between them would have some that are not above zero; what compatibleCurves() refuses.
// The NURBS Book, 10.3.
[[nodiscard]] Result<Loft> lofted(const std::vector<NurbsCurve>& curves, LoftEnds ends);

}  // namespace knotspan
