// How far the points of one mesh are from another: all of its points, not only the vertices.
#pragma once

#include "model/geometry/triangle_mesh.h"

namespace knotspan {

struct MeshDistance {
    double largest = 0;
    Vec3 at{0};       // the point of the first mesh where it is
    double mean = 0;  // by area, of some 100,000 points
    double area = 0;  // of the first mesh
    // No point of the first mesh is further away than `largest` and this.
    double uncertainty = 0;
};

// From `from` to `to`, both with at least one triangle. Searches until the uncertainty is no more than
// `tolerance` or a ten-thousandth of the distance; meshes with very many triangles near each other may leave
// more.
//
// The distance from one triangle T of the other mesh is convex, so over a flat piece it is largest at a
// corner: that bounds the distance from the mesh. A piece whose bound is too large is cut along the sides of
// the prism over T, inside which T is as near as it gets, and the rest is looked at again.
[[nodiscard]] MeshDistance distanceFrom(const TriangleMesh& from, const TriangleMesh& to, double tolerance);

}  // namespace knotspan
