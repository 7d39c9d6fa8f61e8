// A window in a process of its own in which somebody works, until the process is killed.
#pragma once

#include <filesystem>

#include "model/scene/scene.h"

namespace knotspan::testing {

// What main() runs in the other process: opens `file` in a window and moves a control point again and again,
// `steps` times, keeping the model in `folder` all the while. Does not return.
int editForEver(const std::filesystem::path& file, const std::filesystem::path& folder, int steps);

// The scene of the file after that many moves.
[[nodiscard]] Scene editedScene(const Scene& opened, int steps);
// How many moves the scene has seen.
[[nodiscard]] int stepsIn(const Scene& edited);

}  // namespace knotspan::testing
