// Where a new shape stands: an origin, the direction of its own z axis, and about where its own x axis
// points.
#pragma once

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

struct Placement {
    Vec3 origin{0};
    Vec3 axis{0, 0, 1};       // z; of any length
    Vec3 direction{1, 0, 0};  // x, or what lies with x and z in a plane; of any length, not along the axis
};

// From the shape's own coordinates to the placement's: a rotation and a translation, right to the last
// digits. Refuses, with a sentence, numbers that are not finite, an axis or a direction of no length, and a
// direction that lies within a millionth of a radian along the axis.
[[nodiscard]] Result<Mat4> placementMatrix(const Placement& placement);

// Each control point moved by it, its weight kept: points that were equal still are, to the bit. Refuses what
// stands so far from the origin that its own size is lost in the rounding of coordinates.
[[nodiscard]] Result<NurbsSurface> placed(const NurbsSurface& surface, const Placement& placement);

}  // namespace knotspan
