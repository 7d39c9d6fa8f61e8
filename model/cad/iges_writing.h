// IGES files: each object a trimmed surface (144) over a B-spline surface (128), with its name and colour.
//
// Files carry no time: the same model gives the same bytes.
#pragma once

#include <filesystem>

#include "model/core/result.h"
#include "model/scene/scene.h"

namespace knotspan::formats {

// What our files name as the system they come from.
inline constexpr const char* kOurIgesSystem = "Knotspan";

// The file's unit of length is the scene's (millimetres, where IGES has none such), so that its numbers are
// the scene's.
[[nodiscard]] Result<void> writeIges(const Scene& scene, const std::filesystem::path& path);

}  // namespace knotspan::formats
