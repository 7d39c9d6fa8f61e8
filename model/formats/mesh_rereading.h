// A mesh's file that was just written, read back to see what is in it.
#pragma once

#include "model/mesh_files/mesh_files.h"

namespace knotspan::formats {

// In `units`, with z up, whatever the file is in. The extension does not matter.
[[nodiscard]] Result<TriangleMesh> rereadMesh(const std::filesystem::path& path, MeshKind kind,
                                              const std::string& units);

}  // namespace knotspan::formats
