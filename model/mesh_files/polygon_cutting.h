// Polygons with any number of corners, cut into triangles.
#pragma once

#include <span>

#include "model/geometry/triangle_mesh.h"

namespace knotspan::formats {

class PolygonCutting {
public:
    // Appends `corners.size()` - 2 triangles that run round as the polygon does: of a quadrilateral by its
    // shorter diagonal, of a convex polygon a fan, of others ears first. Files whose polygons would take very
    // long, or cross themselves, get fans.
    void cut(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices,
             std::vector<Triangle>& triangles);

private:
    [[nodiscard]] bool project(std::span<const std::uint32_t> corners, const std::vector<Vec3>& vertices);
    [[nodiscard]] double turn(size_t a, size_t b, size_t c) const;
    [[nodiscard]] bool isConvex() const;
    [[nodiscard]] bool isEar(size_t at) const;
    void cutEars(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles);
    void cutFan(std::span<const std::uint32_t> corners, std::vector<Triangle>& triangles) const;

    std::vector<Vec2> flat_;    // the corners in the polygon's plane
    std::vector<size_t> ring_;  // corners that are not cut off yet
    double patience_ = 1e6;     // looks at corners that are left for the file
};

}  // namespace knotspan::formats
