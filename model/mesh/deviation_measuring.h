// How far a mesh really is from the surfaces it was made of, at many places.
#pragma once

#include "model/geometry/grid_evaluation.h"
#include "model/mesh/tessellation.h"

namespace knotspan {

struct MeshDeviation {
    double largest = 0;  // model units
    double largestAngle =
        0;  // degrees, between a triangle's normal and the surface's, either side; 0: not asked
};

[[nodiscard]] double distanceToTriangle(const Vec3& point, const std::array<Vec3, 3>& triangle);

// Each triangle against the surface's points at 16 places of its parameters: the largest distance of such a
// point from the triangle. It may be more than the distance from the mesh, never less, and is never above
// Tessellation::bound (but for rounding). Along outlines of trimmed faces, points of those against the edges
// that stand for them.
[[nodiscard]] MeshDeviation measuredDeviation(const Tessellation& tessellation, const Scene& scene,
                                              bool angles = false, Threads threads = Threads::all);

// The same for any triangles of one surface: the distances of points of the surface from triangles, taken
// together.
class DeviationSampler {
public:
    DeviationSampler(const NurbsSurface& surface, const Mat4& transform, bool angles,
                     Threads threads = Threads::all);

    // Places in a triangle that are looked at, as shares of its corners.
    [[nodiscard]] static const std::vector<Vec3>& places();
    // `u`, `v`: of the surface at each of the places.
    void add(const std::array<Vec3, 3>& triangle, std::span<const SpanParameter> u,
             std::span<const SpanParameter> v);
    [[nodiscard]] MeshDeviation result();

private:
    void look();

    Mat4 transform_;
    bool angles_;
    Threads threads_;
    GridEvaluator<double> evaluator_;
    std::vector<std::array<Vec3, 3>> triangles_;
    std::vector<SpanParameter> u_;
    std::vector<SpanParameter> v_;
    GridSamples<double> samples_;
    MeshDeviation found_;
};

}  // namespace knotspan
