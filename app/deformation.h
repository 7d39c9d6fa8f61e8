// What `render --deform` does to a model between two frames: the same work as a drag, without the hand.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace knotspan::app {

enum class Deformation { none, point, all };

[[nodiscard]] const std::vector<std::string>& deformationNames();
[[nodiscard]] std::optional<Deformation> findDeformation(const std::string& name);

// `rest` at the given frame: control points moved along z by a wave of 1 % of the model's size; frame 0 is
// the model at rest. `point` moves one control point in the middle of the first visible object; `all` moves
// every one, those at one place alike, so that what was joined stays joined.
[[nodiscard]] Scene deformed(const Scene& rest, Deformation deformation, int frame);

}  // namespace knotspan::app
