// Writing a model so that what is in the file is proved to be the model.
#pragma once

#include "model/formats/format_list.h"
#include "model/formats/scene_difference.h"

namespace knotspan::formats {

// Relative: what rounding may cost.
constexpr double kLostNothing = 1e-12;

// As write(), but the file gets its name only after it was read back and differs from the scene by no more
// than kLostNothing. Tells by how much.
[[nodiscard]] Result<SceneDifference> writeVerified(const Scene& scene, const std::filesystem::path& path);

}  // namespace knotspan::formats
