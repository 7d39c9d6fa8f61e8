// A mesh as OpenMesh sees it: another program's view of whether it is a manifold, and of files.
#pragma once

#include <filesystem>

#include "model/geometry/triangle_mesh.h"

namespace knotspan::testing {

struct HalfEdgeFigures {
    bool read = false;  // and every triangle could be taken in
    size_t vertices = 0;
    size_t triangles = 0;
    size_t edges = 0;
    size_t boundaryEdges = 0;
    bool manifold = false;  // the triangles round every vertex are one fan
};

[[nodiscard]] HalfEdgeFigures halfEdgesOf(const TriangleMesh& mesh);
[[nodiscard]] HalfEdgeFigures halfEdgesOf(const std::filesystem::path& file);

}  // namespace knotspan::testing
