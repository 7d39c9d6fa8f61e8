// STEP files (AP214): one product, each object a shell of one face with its name and colour.
//
// Files carry no time: the same model gives the same bytes.
#pragma once

#include <filesystem>

#include "model/core/result.h"
#include "model/scene/scene.h"

namespace knotspan::formats {

// What our files name as the system they come from, and their product.
inline constexpr const char* kOurStepSystem = "Knotspan";
inline constexpr const char* kOurStepProduct = "Knotspan model";

// The file's unit of length is the scene's (millimetres, where STEP has none such), so that its numbers are
// the scene's.
[[nodiscard]] Result<void> writeStep(const Scene& scene, const std::filesystem::path& path);

}  // namespace knotspan::formats
