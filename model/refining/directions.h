// What is there twice, once along u and once along v.
#pragma once

#include "model/geometry/knot_insertion.h"

namespace knotspan {

[[nodiscard]] inline const KnotVector& knotsOf(const NurbsSurface& surface, Direction direction)
{
    return direction == Direction::U ? surface.knotsU() : surface.knotsV();
}

}  // namespace knotspan
