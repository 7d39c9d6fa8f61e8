// The reference meshes of a scene as one mesh, in model space.
#pragma once

#include "model/scene/scene.h"

namespace knotspan {

// Appends those that are visible, vertices and triangles in their order; mirrored ones turned over, so that their
// fronts stay their fronts.
void addPlacedMeshes(const Scene& scene, TriangleMesh& mesh);

}  // namespace knotspan
