// Control points that are one point of the shape: at the seam of a closed surface, at a pole. A hand that
// takes hold of one of them means all.
#pragma once

#include "model/sculpting/point_selection.h"

namespace knotspan {

// With the twins of each selected point, and all of a pole's points where one is selected (net_neighbours.h).
// The selection is of this scene (PointSelection::keepOnly). Looks at borders only.
[[nodiscard]] PointSelection withTwins(const Scene& scene, const PointSelection& selection);

}  // namespace knotspan
