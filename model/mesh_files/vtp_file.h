// VTP: VTK's own files of polygons, through VTK.
#pragma once

#include <filesystem>

#include "model/core/result.h"
#include "model/geometry/triangle_mesh.h"

namespace knotspan::formats {

// Coordinates to the last bit, compressed. Overwrites the file.
[[nodiscard]] Result<void> writeVtp(const std::filesystem::path& path, const TriangleMesh& mesh);

// Polygons and strips, with float or double coordinates. To be called in a process of its own
// (isolated_import.h): VTK believes what files say.
[[nodiscard]] Result<TriangleMesh> readVtp(const std::filesystem::path& path);

}  // namespace knotspan::formats
