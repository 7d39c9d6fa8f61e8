// Meshes as VTK sees them: another program's view of files and of distances.
#pragma once

#include <filesystem>
#include <memory>

#include "model/geometry/triangle_mesh.h"

namespace knotspan::testing {

// What VTK's own reader of the extension makes of the file (.vtp, .glb, .stl, .ply, .obj), vertices as they
// stand in it; without triangles where it cannot read it.
[[nodiscard]] TriangleMesh vtkMeshOf(const std::filesystem::path& file);

// Distances from a mesh by VTK's static cell locator.
class VtkDistances {
public:
    explicit VtkDistances(const TriangleMesh& mesh);
    ~VtkDistances();
    VtkDistances(const VtkDistances&) = delete;
    VtkDistances& operator=(const VtkDistances&) = delete;
    [[nodiscard]] double to(const Vec3& point);

private:
    struct Locator;
    std::unique_ptr<Locator> locator_;
};

}  // namespace knotspan::testing
