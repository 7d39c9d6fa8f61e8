// A flight around a model, the same for everybody, so that reports of different machines compare.
#pragma once

#include <vector>

#include "model/scene/scene.h"
#include "renderer/frame.h"

namespace knotspan {

// `count` views: once around all that is visible, up and down twice, and twice close to it. Empty where
// nothing is visible.
[[nodiscard]] std::vector<Camera> flightAround(const Scene& scene, size_t count, double aspect);

}  // namespace knotspan
