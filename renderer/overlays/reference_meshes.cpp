#include "renderer/overlays/reference_meshes.h"

#include <algorithm>

#include "renderer/scene/patch_table.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

void ReferenceMeshes::sync(const Scene& scene)
{
    std::vector<Held> wanted;
    for (const auto& [id, object] : scene.meshes())
        if (object->visible && !object->mesh->triangles.empty())
            wanted.push_back({id, object, object->box.centre()});
    if (holdsMeshesOf(wanted)) {
        for (size_t k = 0; k < wanted.size(); ++k)
            meshes_[k].object = wanted[k].object;
        return;
    }
    meshes_ = std::move(wanted);
    try {
        send();
    } catch (...) {
        forget();
        throw;
    }
}

bool ReferenceMeshes::holdsMeshesOf(const std::vector<Held>& wanted) const
{
    return std::equal(meshes_.begin(), meshes_.end(), wanted.begin(), wanted.end(),
                      [](const Held& held, const Held& other) {
                          return held.id == other.id && held.object->mesh == other.object->mesh;
                      });
}

void ReferenceMeshes::send()
{
    size_t vertexCount = 0;
    size_t triangleCount = 0;
    for (const Held& held : meshes_) {
        vertexCount += held.object->mesh->vertices.size();
        triangleCount += held.object->mesh->triangles.size();
    }
    uploader_.forget(vertices_);
    uploader_.forget(corners_);
    if (meshes_.empty()) {
        vertices_ = {};
        corners_ = {};
        return;
    }
    if (pipeline_.get() == VK_NULL_HANDLE)
        pipeline_ = makeGraphicsPipeline(device_, bindings_,
                                         {.stages = {"reference_mesh.vert", "reference_mesh.frag"}});
    bindings_.provide(BINDING_MESH_VERTICES, vertices_, vertexCount * sizeof(gpu::vec3));
    bindings_.provide(BINDING_MESH_TRIANGLES, corners_, triangleCount * sizeof(Triangle));
    std::uint32_t firstVertex = 0;
    std::uint32_t firstCorner = 0;
    for (Held& held : meshes_) {
        const TriangleMesh& mesh = *held.object->mesh;
        const auto places = uploader_.room<gpu::vec3>(vertices_, firstVertex, mesh.vertices.size());
        std::transform(mesh.vertices.begin(), mesh.vertices.end(), places.begin(),
                       [&](const Vec3& vertex) { return gpu::vec3(vertex - held.origin); });
        held.firstCorner = firstCorner;
        auto corner = uploader_.room<std::uint32_t>(corners_, firstCorner, 3 * mesh.triangles.size()).begin();
        for (const Triangle& triangle : mesh.triangles)
            for (const std::uint32_t vertex : triangle)
                *corner++ = firstVertex + vertex;
        firstVertex += static_cast<std::uint32_t>(mesh.vertices.size());
        firstCorner += static_cast<std::uint32_t>(3 * mesh.triangles.size());
    }
}

void ReferenceMeshes::draw(VkCommandBuffer commands, const Camera& camera,
                           const std::vector<ObjectId>& highlighted) const
{
    if (meshes_.empty())
        return;
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    for (const Held& held : meshes_) {
        const bool chosen = std::find(highlighted.begin(), highlighted.end(), held.id) != highlighted.end();
        const gpu::MeshConstants constants{
            gpu::mat4x3(glm::dmat4x3(camera.viewFrom(held.object->transform, held.origin))),
            linearColour(held.object->colour), chosen ? 1.0F : 0.0F};
        bindings_.push(commands, &constants, sizeof(constants));
        vkCmdDraw(commands, static_cast<std::uint32_t>(3 * held.object->mesh->triangles.size()), 1,
                  held.firstCorner, 0);
    }
}

void ReferenceMeshes::listMemory(std::vector<HeldMemory>& to) const
{
    if (!meshes_.empty())
        to.push_back({"reference meshes", vertices_.bytes() + corners_.bytes()});
}

}  // namespace knotspan
