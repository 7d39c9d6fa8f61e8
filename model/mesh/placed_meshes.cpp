#include "model/mesh/placed_meshes.h"

#include <utility>

#include <glm/matrix.hpp>

namespace knotspan {

void addPlacedMeshes(const Scene& scene, TriangleMesh& mesh)
{
    for (const auto& [id, object] : scene.meshes()) {
        if (!object->visible)
            continue;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const bool mirrored = glm::determinant(object->transform) < 0;
        for (const Vec3& vertex : object->mesh->vertices)
            mesh.vertices.push_back(transformed(vertex, object->transform));
        for (auto [a, b, c] : object->mesh->triangles) {
            if (mirrored)
                std::swap(b, c);
            mesh.triangles.push_back({first + a, first + b, first + c});
        }
    }
}

}  // namespace knotspan
