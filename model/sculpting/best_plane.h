// The plane that fits points best: the sum of squared distances, each with its weight, is the least.
#pragma once

#include <vector>

#include "model/core/space.h"

namespace knotspan {

struct BestPlane {
    Vec3 point{0};  // the points' weighted mean
    Vec3 normal{0, 0, 1};
};

// Weights above 0, at least one point. Where several planes fit alike (points on a line), one of them.
[[nodiscard]] BestPlane bestPlaneOf(const std::vector<Vec3>& points, const std::vector<double>& weights);

}  // namespace knotspan
