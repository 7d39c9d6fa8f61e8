// The formats that hold a mesh and nothing else. What they give is one reference mesh, or, of glTF, several.
// They are written by mesh_export.h, because surfaces become a mesh only at a stated deviation.
#pragma once

#include "model/files/format.h"

namespace knotspan::formats {

[[nodiscard]] Format stlFormat();
[[nodiscard]] Format plyFormat();
[[nodiscard]] Format offFormat();
[[nodiscard]] Format vtpFormat();
[[nodiscard]] Format gltfFormat();

}  // namespace knotspan::formats
