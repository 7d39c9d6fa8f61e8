// Files with a mesh, as bytes that anyone may have written: STL (text and binary), PLY (text and binary,
// either byte first), OFF, and the mesh of a glTF file.
//
// Of our own, and in the program itself: OpenMesh leaves out what is no manifold, VTK's readers make floats
// of all coordinates, and a reader that checks every number against the size of the file needs no process of
// its own. Each refuses with a sentence what it cannot understand, and takes no more memory than a few times
// the file's size.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/core/result.h"
#include "model/geometry/triangle_mesh.h"
#include "model/scene/scene.h"

namespace knotspan::formats {

// Corners with the same coordinates become one vertex.
[[nodiscard]] Result<TriangleMesh> meshFromStl(std::string_view bytes);
[[nodiscard]] Result<TriangleMesh> meshFromPly(std::string_view bytes);
[[nodiscard]] Result<TriangleMesh> meshFromOff(std::string_view bytes);

// The meshes of the file's scene, in metres, turned so that z is up. `bytes`: a .glb or a .gltf, `folder` is
// where the files lie that it names.
[[nodiscard]] Result<Scene> sceneFromGltf(std::string_view bytes, const std::filesystem::path& folder);

}  // namespace knotspan::formats
