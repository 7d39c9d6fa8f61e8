// Normals for files that are drawn: smooth over a curved surface, sharp at creases.
#pragma once

#include <array>
#include <vector>

#include "model/geometry/triangle_mesh.h"

namespace knotspan::formats {

// The vertices of the mesh once for each normal they need.
struct ShadedMesh {
    std::vector<std::uint32_t> vertices;        // of the mesh
    std::vector<std::array<float, 3>> normals;  // of length 1, each for the vertex above it
    std::vector<Triangle> triangles;            // between these; in the mesh's order
};

// A corner's normal is that of the triangles around its vertex which turn less than 30 degrees from its own,
// each by its angle there.
[[nodiscard]] ShadedMesh shaded(const TriangleMesh& mesh);

}  // namespace knotspan::formats
