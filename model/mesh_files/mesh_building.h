// A mesh as a file tells it: vertices, and polygons between them. Throws Error, which the readers catch.
#pragma once

#include "model/core/result.h"
#include "model/mesh_files/polygon_cutting.h"

namespace knotspan::formats {

class MeshBuilding {
public:
    // Numbers it; refuses a coordinate that is not finite.
    std::uint32_t vertex(const Vec3& position);
    // The same for formats that repeat vertices: one with the same coordinates, bit for bit, has its number.
    std::uint32_t weldedVertex(const Vec3& position);
    [[nodiscard]] size_t vertices() const { return mesh_.vertices.size(); }

    // As triangles, without those that have a vertex twice. Refuses fewer than three corners, a vertex that
    // is not there (by the time of the call) and more triangles than a scene may have.
    void polygon(std::span<const std::uint32_t> corners);
    [[nodiscard]] bool isEmpty() const { return mesh_.triangles.empty(); }
    void reserve(size_t vertices, size_t triangles);

    // Without vertices that no triangle has, the others in their order. Refuses a mesh without triangles.
    [[nodiscard]] TriangleMesh take();
    [[nodiscard]] size_t droppedTriangles() const { return dropped_; }

private:
    void growTable();
    [[nodiscard]] size_t placeOf(const Vec3& position) const;

    TriangleMesh mesh_;
    PolygonCutting cutting_;
    std::vector<Triangle> cut_;
    std::vector<std::uint32_t> table_;  // numbers of vertices by their hash; empty places have the largest
    size_t dropped_ = 0;
};

}  // namespace knotspan::formats
