// Which surfaces of a mesh have to be turned over, so that neighbours look to one side and bodies outwards.
#pragma once

#include "model/analysis/border_curves.h"
#include "model/geometry/triangle_mesh.h"
#include "model/mesh/mesh_vertices.h"
#include "model/mesh/tessellation.h"

namespace knotspan {

struct FacingOut {
    std::vector<char>
        turned;  // by surface: triangles that are counter-clockwise in (u, v) have to be turned over
    bool twisted = false;  // some cannot be turned consistently, as on a Moebius strip
};

// `firstTriangles`: of each surface, and behind the last; triangles are counter-clockwise in (u, v). The
// front is where S_u x S_v points in the object's own coordinates (a mirroring transform turns it over). Of
// surfaces that are joined the most triangles keep theirs; where they enclose a body, because all of them are
// `closed` by others (or themselves) all around, the front is the outside.
[[nodiscard]] FacingOut facingOut(const TriangleMesh& mesh, const std::vector<size_t>& firstTriangles,
                                  const std::vector<PlacedSurface>& surfaces,
                                  const std::vector<MeshVertices::Seam>& seams,
                                  const std::vector<char>& closed);
// Which surfaces meet exactly one other side all along their border.
[[nodiscard]] std::vector<char> closedAllAround(const CoincidentEdges& edges);

// Turns the surfaces' triangles over, and says where they cannot be turned one way.
void turnOut(Tessellation& tessellation, const FacingOut& facing, const std::vector<size_t>& firstTriangles);
// Vertices that lines which are one point had beside it.
void dropUnused(Tessellation& tessellation);

}  // namespace knotspan
