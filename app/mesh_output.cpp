#include "app/mesh_output.h"

#include <iostream>

#include "app/output.h"
#include "model/analysis/surface_bounds.h"
#include "model/mesh/deviation_measuring.h"

namespace knotspan::app {

namespace {

double usualDeviation(const Scene& scene)
{
    Box box;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            box.add(surfaceBounds(object->surface, object->transform));
    const double size = box.diagonal();
    return size > 0 ? size / 1000 : 1;
}

}  // namespace

std::optional<formats::MeshKind> meshKindOf(const std::filesystem::path& path, const MeshOptions& options)
{
    const auto kind = formats::meshKindOf(path);
    if (kind == formats::MeshKind::obj && !(options.deviation > 0) && !options.angleDegrees)
        return std::nullopt;
    return kind;
}

Result<void> writeMeshOf(const Scene& scene, const std::filesystem::path& path, formats::MeshKind kind,
                         const MeshOptions& options)
{
    const double asked = options.deviation > 0 ? options.deviation : usualDeviation(scene);
    auto made = tessellate(scene, {.deviation = asked, .angleDegrees = options.angleDegrees});
    if (!made)
        return tl::unexpected(made.error().at(path.string()));
    const double moved = formats::roundTo(kind, made->mesh);
    const MeshDeviation measured = measuredDeviation(*made, scene, options.angleDegrees.has_value());
    if (auto written = formats::writeMesh(path, made->mesh, kind); !written)
        return written;
    for (const std::string& note : made->notes)
        tell(path.string() + ": " + note);
    if (measured.largest > asked && moved > 0)
        tell(path.string() +
             ": STL's numbers have 7 digits, too few for this deviation so far from the origin. "
             "Choose PLY, OBJ or OFF.");
    const MeshTopology topology = topologyOf(made->mesh);
    std::cout << path.string() << ": " << made->mesh.triangles.size() << " triangles, "
              << made->mesh.vertices.size() << " vertices, " << topology.boundaryEdges << " boundary edges, "
              << topology.nonManifoldEdges << " non-manifold edges; deviation asked " << asked << ", bound "
              << made->bound + moved << ", measured " << measured.largest;
    if (options.angleDegrees)
        std::cout << "; normals asked " << *options.angleDegrees << ", measured " << measured.largestAngle
                  << " degrees";
    std::cout << '\n';
    return {};
}

}  // namespace knotspan::app
