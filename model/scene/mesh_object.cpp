#include "model/scene/mesh_object.h"

namespace knotspan {

bool MeshObject::operator==(const MeshObject& other) const
{
    return name == other.name && colour == other.colour && transform == other.transform &&
           visible == other.visible && (mesh == other.mesh || *mesh == *other.mesh);
}

MeshObject meshObject(std::string name, TriangleMesh mesh)
{
    MeshObject object;
    object.name = std::move(name);
    for (const Vec3& vertex : mesh.vertices)
        object.box.add(vertex);
    object.mesh = std::make_shared<const TriangleMesh>(std::move(mesh));
    return object;
}

}  // namespace knotspan
