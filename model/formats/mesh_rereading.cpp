#include "model/formats/mesh_rereading.h"

#include "model/files/text_file.h"
#include "model/formats/obj_format.h"
#include "model/mesh_files/mesh_reading.h"
#include "model/mesh_files/vtp_file.h"

namespace knotspan::formats {

namespace {

Result<TriangleMesh> onlyMeshOf(const Scene& scene, double scale)
{
    if (scene.meshes().size() != 1)
        return failure("What was written is read back as another model");
    const MeshObject& object = *scene.meshes().begin()->second;
    TriangleMesh mesh = *object.mesh;
    for (Vec3& vertex : mesh.vertices)
        vertex = transformed(vertex, object.transform) * scale;
    return mesh;
}

}  // namespace

Result<TriangleMesh> rereadMesh(const std::filesystem::path& path, MeshKind kind, const std::string& units)
{
    if (kind == MeshKind::vtp)
        return readVtp(path);
    const auto bytes = wholeText(path, 4095, "mesh");
    if (!bytes)
        return tl::unexpected(bytes.error());
    switch (kind) {
    case MeshKind::stl:
        return meshFromStl(*bytes);
    case MeshKind::ply:
        return meshFromPly(*bytes);
    case MeshKind::off:
        return meshFromOff(*bytes);
    case MeshKind::obj:
        return sceneFromObj(*bytes).and_then(
            [](const Import& import) { return onlyMeshOf(import.scene, 1); });
    case MeshKind::glb:
    case MeshKind::vtp:
        break;
    }
    return sceneFromGltf(*bytes, {}).and_then([&](const Scene& scene) {
        return onlyMeshOf(scene, 1 / metresIn(units));
    });
}

}  // namespace knotspan::formats
