// Circular arcs as rational quadratic curves: what every turned surface is made of.
#pragma once

#include <vector>

#include "model/geometry/knot_vector.h"

namespace knotspan {

// A control point of the unit circle round the origin, unweighted, with its weight.
struct ArcPoint {
    double x;
    double y;
    double weight;
};

// The control points of the arc from (1, 0) through `degrees` (not 0, at most 360 either way; positive turns
// x towards y), in the fewest pieces of equal length of at most 45 degrees: 2 pieces + 1 of them. Arcs of
// whole eighths are parts of one circle to the bit; mirror images in it are too, and the full circle ends
// where it began. The NURBS Book, 7.5.
[[nodiscard]] std::vector<ArcPoint> arcPoints(double degrees);

// For so many pieces: degree 2, double knots at 0, 1, ..., pieces.
[[nodiscard]] KnotVector arcKnots(int pieces);

}  // namespace knotspan
