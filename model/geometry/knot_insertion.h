// Pure functions that give a surface more knots, or a part of it as a surface of its own, without changing
// its shape.
//
// The same knots and control points give the same bits, wherever they stand in a larger net, so that
// neighbours cut from one surface share their border exactly.
#pragma once

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

enum class Direction { U, V };

// The surface with the knot `value` inserted `times` more times. The value lies inside the domain or on its
// border; afterwards it may stand there at most `degree` times. The NURBS Book, A5.3.
[[nodiscard]] NurbsSurface withKnotInserted(const NurbsSurface& surface, Direction direction, double value,
                                            int times = 1);

// The surface with each of `values` inserted once, in whatever order; a value may stand there several times.
[[nodiscard]] NurbsSurface withKnotsInserted(const NurbsSurface& surface, Direction direction,
                                             const std::vector<double>& values);

// The part between two parameters of the domain, start < end, as a clamped surface of its own with the same
// parameters. The NURBS Book, 5.3.
[[nodiscard]] NurbsSurface clampedPart(const NurbsSurface& surface, Direction direction, double start,
                                       double end);

}  // namespace knotspan
