// The triangles of one KSQuad: a regular grid inside, joined to whatever vertices its four edges have.
//
// As shaders/shared/ring.glsl does it. Two chains of vertices run beside each other; each triangle takes one
// step along the one whose next vertex is less far. Where both have steps no longer than 1/n along the
// direction they run in, every triangle fits into a length of 1/n: with a the outer and b the inner position
// and a', b' the next ones, a <= b' and b <= a' hold throughout.
#pragma once

#include "model/mesh/mesh_vertices.h"
#include "model/geometry/triangle_mesh.h"

namespace knotspan {

using TriangleParameters = std::array<Vec2, 3>;  // t in [0, 1] x [0, 1] of the KSQuad, by corner

class QuadTriangles {
public:
    // Appends to both, counter-clockwise in (u, v); triangles with a vertex twice are left out.
    QuadTriangles(std::vector<Triangle>& triangles, std::vector<TriangleParameters>& parameters)
        : triangles_(triangles),
          parameters_(parameters)
    {
    }

    // `rising`: cells inside are cut from (0, 0) to (1, 1).
    void add(const MeshVertices& vertices, std::uint32_t surface, std::uint32_t a, std::uint32_t b,
             std::uint32_t ksquad, bool rising);

private:
    struct Corner {
        std::uint32_t vertex = 0;
        Vec2 t{};
        double position = 0;  // along the chain's direction
    };
    using Chain = std::vector<Corner>;

    void addInside(const Grid& grid, std::uint32_t first, bool rising);
    void addRing(const Grid& grid, std::uint32_t first);
    void addBand(const Grid& grid);
    // Between two chains; `left`: the inner one is to the left of the outer one.
    void zip(const Chain& outer, const Chain& inner, bool left);
    void addTriangle(const Corner& a, const Corner& b, const Corner& c);
    [[nodiscard]] Chain chainAlong(Side side, bool backwards) const;

    std::vector<Triangle>& triangles_;
    std::vector<TriangleParameters>& parameters_;
    std::array<std::vector<MeshVertices::OnSide>, 4> sides_;
};

}  // namespace knotspan
