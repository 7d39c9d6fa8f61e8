// Which triangle of a mesh is nearest to a point: a tree of boxes.
//
// Of our own: VTK 9.1's locators take 10 to 20 microseconds for a point near a mesh of 300,000 triangles and
// a millisecond for one that is half its size away; this takes 1 to 3 for either. They check it
// (tests/model/mesh).
#pragma once

#include "model/geometry/triangle_mesh.h"

namespace knotspan {

class NearestTriangle {
public:
    // The mesh, which has at least one triangle, has to outlive it.
    explicit NearestTriangle(const TriangleMesh& mesh);

    struct Found {
        size_t triangle = 0;
        double distance = 0;
    };
    // `guess`: a triangle that may be near; the better, the quicker. From any thread.
    [[nodiscard]] Found to(const Vec3& point, size_t guess = 0) const;
    [[nodiscard]] std::array<Vec3, 3> corners(size_t triangle) const;

private:
    // Boxes of triangles first_ .. end_ of order_, the first child behind its parent.
    struct Node {
        Box box;
        std::uint32_t first = 0;
        std::uint32_t end = 0;
        std::uint32_t second = 0;  // the other child; 0: a leaf
    };
    void build(std::uint32_t first, std::uint32_t end, const std::vector<Vec3>& centres);

    const TriangleMesh& mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace knotspan
