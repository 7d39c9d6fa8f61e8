// Which surfaces of a mesh have to be turned over, so that neighbours look to one side and bodies outwards.
#pragma once

#include "model/analysis/border_curves.h"
#include "model/mesh/mesh_vertices.h"
#include "model/geometry/triangle_mesh.h"

namespace knotspan {

struct FacingOut {
    std::vector<char>
        turned;  // by surface: triangles that are counter-clockwise in (u, v) have to be turned over
    bool twisted = false;  // some cannot be turned consistently, as on a Moebius strip
};

// `firstTriangles`: of each surface, and behind the last; triangles are counter-clockwise in (u, v). The
// front is where S_u x S_v points in the object's own coordinates (a mirroring transform turns it over). Of
// surfaces that are joined the most triangles keep theirs; where they enclose a body, the front is the
// outside.
[[nodiscard]] FacingOut facingOut(const TriangleMesh& mesh, const std::vector<size_t>& firstTriangles,
                                  const std::vector<PlacedSurface>& surfaces, const CoincidentEdges& edges,
                                  const std::vector<MeshVertices::Seam>& seams);

}  // namespace knotspan
