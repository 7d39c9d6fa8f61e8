// A mesh of triangles that stands in a scene to be looked at and compared with, not to be shaped: a scan, an
// older state, what another program made of the model. Immutable once it is in a Scene.
#pragma once

#include <memory>
#include <string>

#include "model/geometry/triangle_mesh.h"
#include "model/scene/scene_object.h"

namespace knotspan {

// A .knotspan file holds as many.
constexpr size_t kMostMeshTriangles = 12'000'000;

struct MeshObject {
    std::string name;  // UTF-8, may be empty
    Colour colour;
    Mat4 transform{1.0};  // object to model space, affine and invertible
    bool visible = true;
    std::shared_ptr<const TriangleMesh> mesh;  // never null
    Box box;                                   // around the mesh's vertices

    // Meshes of equal vertices and triangles are equal.
    [[nodiscard]] bool operator==(const MeshObject& other) const;

    // A box around the transformed vertices, in model space.
    [[nodiscard]] Box bounds() const { return transformed(box, transform); }
};

[[nodiscard]] MeshObject meshObject(std::string name, TriangleMesh mesh);

using SharedMesh = std::shared_ptr<const MeshObject>;

}  // namespace knotspan
