// `knotspan convert` to a mesh: tessellated, measured, written, told.
#pragma once

#include <optional>

#include "model/formats/mesh_files.h"
#include "model/scene/scene.h"

namespace knotspan::app {

struct MeshOptions {
    double deviation = 0;  // 0: a thousandth of the model's diagonal
    std::optional<double> angleDegrees;
};

// What the file is if it is written with these options: an .obj is a mesh only where a deviation is asked
// for.
[[nodiscard]] std::optional<formats::MeshKind> meshKindOf(const std::filesystem::path& path,
                                                          const MeshOptions& options);

// Prints a line on standard output: triangles, what was asked, proved and measured.
[[nodiscard]] Result<void> writeMeshOf(const Scene& scene, const std::filesystem::path& path,
                                       formats::MeshKind kind, const MeshOptions& options);

}  // namespace knotspan::app
