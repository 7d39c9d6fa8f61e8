// The area of a surface as it stands in a model, with an estimate of how far off it is; and of a mesh.
#pragma once

#include <functional>

#include "model/geometry/nurbs_surface.h"
#include "model/geometry/triangle_mesh.h"

namespace knotspan {

struct Area {
    double value = 0;
    double error = 0;  // an estimate, seldom below what it estimates; no bound
};

// Of the whole surface after its affine transform, in model units squared: trim loops cut nothing out, and
// what a surface covers twice counts twice. Gauss's rule of 8 x 8 points on each KSQuad, held against that of
// 5 x 5, and on quarters of it where the two differ by more than about 1e-10 of the whole, down to where the
// normal is no smooth function. Stops early, with too small a value and an infinite error, once `isOff` says
// true. Only of the KSQuads that `takes` takes, by their numbers along u and v; of all where it is empty.
using KsQuadChoice = std::function<bool(int, int)>;
[[nodiscard]] Area surfaceArea(
    const NurbsSurface& surface, const Mat4& transform,
    const std::function<bool()>& isOff = [] { return false; }, const KsQuadChoice& takes = {});

// The sum of the triangles.
[[nodiscard]] double meshArea(const TriangleMesh& mesh, const Mat4& transform);

}  // namespace knotspan
