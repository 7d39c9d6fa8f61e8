// Triangles between numbered vertices, and what of a mesh is decided by the numbers alone: whether it is
// closed, a manifold, turned one way.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/core/space.h"

namespace knotspan {

using Triangle = std::array<std::uint32_t, 3>;  // counter-clockwise seen from the front

struct TriangleMesh {
    std::vector<Vec3> vertices;  // in model space
    std::vector<Triangle> triangles;

    [[nodiscard]] bool operator==(const TriangleMesh&) const = default;
};

struct MeshTopology {
    size_t edges = 0;
    size_t boundaryEdges = 0;     // of one triangle
    size_t nonManifoldEdges = 0;  // of three or more
    size_t turnedEdges = 0;       // of two triangles that run along them the same way
    size_t degenerate = 0;        // triangles with a vertex twice, which count for no edge
    size_t usedVertices = 0;
    long euler = 0;  // used vertices - edges + triangles

    [[nodiscard]] bool isClosedManifold() const
    {
        return boundaryEdges == 0 && nonManifoldEdges == 0 && turnedEdges == 0 && degenerate == 0;
    }
};
[[nodiscard]] MeshTopology topologyOf(const TriangleMesh& mesh);

// Of a closed mesh; above zero where its fronts look outwards.
[[nodiscard]] double volumeOf(const TriangleMesh& mesh);

}  // namespace knotspan
