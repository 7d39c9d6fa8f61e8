// Bodies with formulas of their own for what lies inside.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/geometry/nurbs_surface.h"

namespace knotspan::testing {

using Inside = std::function<bool(const Vec3&)>;

// Of the samples sphere and torus, by their radii; of the knot, by a fine mesh that is made of it once.
[[nodiscard]] Inside insideOf(const std::string& sample);
// The distance to the sample's surface: of the knot, to the points of that mesh.
[[nodiscard]] double distanceTo(const std::string& sample, const Vec3& point);

// Six faces, told with different directions.
[[nodiscard]] std::vector<NurbsSurface> boxFaces(const Vec3& low, const Vec3& high);

// Closed, with one side only; it goes through itself.
[[nodiscard]] NurbsSurface kleinBottle();

}  // namespace knotspan::testing
