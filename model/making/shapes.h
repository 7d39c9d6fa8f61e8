// Exact surfaces of simple shapes anywhere in space, from numbers that a user typed. Normals (S_u x S_v)
// point outwards, the plane's along its axis. Round shapes run round the axis with u, by the right hand, in
// eight arcs.
//
// Each refuses, with a sentence, sizes that are not finite, not above zero or beyond 1e-60 .. 1e60, and what
// Placement refuses. Sizes are in model units.
#pragma once

#include "model/making/placement.h"

namespace knotspan {

// The rectangle around the origin across the axis, degree 1: u along the direction, v across it.
[[nodiscard]] Result<NurbsSurface> planeShape(const Placement& placement, double sizeU, double sizeV);

// From the origin up the axis, open at both ends.
[[nodiscard]] Result<NurbsSurface> cylinderShape(const Placement& placement, double radius, double height);

// From the origin, with `radiusBelow`, up the axis to `radiusAbove`, open at both ends. One radius may be 0:
// there the surface has a pole. The height may be 0 where the radii differ: a flat ring or disc, whose normal
// points up the axis where the lower radius is the greater one.
[[nodiscard]] Result<NurbsSurface> coneShape(const Placement& placement, double radiusBelow,
                                             double radiusAbove, double height);

// Around the origin; poles on the axis, v runs from the lower to the upper one.
[[nodiscard]] Result<NurbsSurface> sphereShape(const Placement& placement, double radius);

// Around the origin, its tube's middle in the plane across the axis: 0 < minor < major.
[[nodiscard]] Result<NurbsSurface> torusShape(const Placement& placement, double major, double minor);

}  // namespace knotspan
