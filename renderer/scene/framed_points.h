// The points that a view of a whole scene shows.
#pragma once

#include <vector>

#include "model/scene/scene.h"

namespace knotspan {

// As Scene::hullPoints, but of a surface that trim loops leave a part of: places on the surface, spread over
// the part of its parameters that the loops reach over. So a face that was cut out of a far larger surface
// fills the view. For cameras: a bulge between places may reach out by some hundredths.
[[nodiscard]] std::vector<Vec3> framedPoints(const Scene& scene);

}  // namespace knotspan
