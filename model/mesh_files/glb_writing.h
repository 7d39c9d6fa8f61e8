// Meshes as glTF 2.0 in one binary file (.glb).
//
// Of our own: VTK 9.1's writer makes .gltf alone, from city models, and links VTK's rendering.
#pragma once

#include <string>

#include "model/geometry/triangle_mesh.h"
#include "model/mesh_files/mesh_output.h"

namespace knotspan::formats {

// glTF's positions are floats. They are taken from here, a vertex, so that a model far from the origin keeps
// its digits.
[[nodiscard]] Vec3 glbOrigin(const TriangleMesh& mesh);

// `metres`: in one of the mesh's units. glTF is in metres with y up: the file's node says how the mesh, which
// keeps its own unit and has z up, stands in it. With normals; vertices at creases stand once for each.
void writeGlb(MeshOutput& out, const TriangleMesh& mesh, double metres);

// Whether the format can count so much.
[[nodiscard]] bool fitsGlb(const TriangleMesh& mesh);

}  // namespace knotspan::formats
