// Gives one direction of a surface a higher degree without changing its shape.
#pragma once

#include "model/geometry/knot_insertion.h"

namespace knotspan {

// The surface with `degree` along `direction`, which is not below what it has and at most kMaxDegree. Each
// knot stands there as many more times as the degree rises, so that the surface is as smooth across it as
// before. A direction that is not clamped is clamped first. Control points are means of old ones, so nothing
// is lost to rounding but a few units of the last place, and corners keep their bits.
[[nodiscard]] NurbsSurface withDegree(const NurbsSurface& surface, Direction direction, int degree);

}  // namespace knotspan
