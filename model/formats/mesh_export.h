// A scene as a file with a mesh: surfaces at a stated deviation, reference meshes as they are.
#pragma once

#include <optional>

#include "model/mesh_files/mesh_files.h"
#include "model/scene/scene.h"

namespace knotspan::formats {

struct MeshExportOptions {
    MeshKind kind = MeshKind::stl;
    double deviation = 0;  // in the scene's units; 0: usualDeviation()
    std::optional<double> angleDegrees;
    // Reads the file back before it gets its name: same topology, and `measured` is of what was read.
    bool verify = false;
};

struct MeshCounts {
    size_t triangles = 0;
    size_t vertices = 0;
};

struct MeshExportReport {
    MeshCounts counts;
    size_t boundaryEdges = 0;
    size_t nonManifoldEdges = 0;
    // How far the triangles are from the surfaces, in the scene's units: what was asked for, what is proved,
    // the most that was found. Nothing where the scene has meshes alone, which are written as they are.
    struct Deviation {
        double asked = 0;
        double bound = 0;
        double measured = 0;
        double angleDegrees = 0;  // measured, where an angle was asked for
        [[nodiscard]] bool isKept() const { return bound <= asked; }
    };
    std::optional<Deviation> deviation;
    std::vector<std::string> notes;  // sentences for the user
};

// A thousandth of the visible surfaces' diagonal.
[[nodiscard]] double usualDeviation(const Scene& scene);

// What exportMesh() would write, by making it: takes as long, but for the writing. From any thread.
[[nodiscard]] Result<MeshCounts> meshCounts(const Scene& scene, const MeshExportOptions& options);

// Of what is visible. From any thread; the file is the old one or the new one, whole. Where edges of the
// model are further apart than the deviation it is written all the same: the report says so.
[[nodiscard]] Result<MeshExportReport> exportMesh(const Scene& scene, const std::filesystem::path& path,
                                                  const MeshExportOptions& options);

}  // namespace knotspan::formats
