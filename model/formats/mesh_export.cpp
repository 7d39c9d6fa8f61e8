#include "model/formats/mesh_export.h"

#include <algorithm>
#include <optional>
#include <set>

#include "model/analysis/surface_bounds.h"
#include "model/core/joined_sets.h"
#include "model/files/file_replacement.h"
#include "model/formats/mesh_rereading.h"
#include "model/mesh/deviation_measuring.h"
#include "model/mesh/placed_meshes.h"
#include "model/mesh/tessellation.h"
#include "model/mesh_files/mesh_building.h"

namespace knotspan::formats {

namespace {

// The tessellated surfaces first, then the meshes that the scene has.
struct Made {
    Tessellation surfaces;  // whose mesh is the first part of `mesh`
    TriangleMesh mesh;
    double asked = 0;  // 0: the scene has no surfaces that are shown
    double moved = 0;  // how far vertices are from where they were meant, because of the file's numbers
};

Result<Made> makeWithin(const Scene& scene, const MeshExportOptions& options, double deviation)
{
    const auto isVisible = [](const auto& entry) { return entry.second->visible; };
    const bool hasMeshes = std::any_of(scene.meshes().begin(), scene.meshes().end(), isVisible);
    Made made;
    if (!hasMeshes || std::any_of(scene.objects().begin(), scene.objects().end(), isVisible)) {
        made.asked = deviation > 0 ? deviation : usualDeviation(scene);
        auto surfaces = tessellate(scene, {.deviation = made.asked, .angleDegrees = options.angleDegrees});
        if (!surfaces)
            return tl::unexpected(surfaces.error());
        made.surfaces = *std::move(surfaces);
        made.mesh = made.surfaces.mesh;
    }
    addPlacedMeshes(scene, made.mesh);
    if (made.mesh.vertices.size() > INT32_MAX)
        return failure("The mesh has more vertices than a file can count", "Choose a larger deviation");
    made.moved = roundTo(options.kind, made.mesh);
    return made;
}

// As the file will have it. What its numbers are off by is taken from the deviation that triangles may use
// up.
Result<Made> make(const Scene& scene, const MeshExportOptions& options)
{
    auto made = makeWithin(scene, options, options.deviation);
    if (!made || made->asked == 0 || made->surfaces.bound + made->moved <= made->asked || made->moved == 0)
        return made;
    // Edges of the model are further apart: no format would help.
    if (made->surfaces.bound > made->asked)
        return made;
    const double asked = made->asked;
    if (made->moved < asked / 2) {
        made = makeWithin(scene, options, asked - 1.5 * made->moved);
        if (!made)
            return made;
        made->asked = asked;
        if (made->surfaces.bound + made->moved <= asked)
            return made;
    }
    std::ostringstream text;
    text << "Numbers of 7 digits, as the format has, move vertices by " << made->moved
         << " here, which is too much for a deviation of " << asked;
    return failure(text.str(), "Choose PLY, OBJ, OFF or VTP, which have 17 digits, or a larger deviation");
}

void noteHidden(const Scene& scene, std::vector<std::string>& notes)
{
    const auto isHidden = [](const auto& entry) { return !entry.second->visible; };
    const auto hidden = std::count_if(scene.objects().begin(), scene.objects().end(), isHidden) +
                        std::count_if(scene.meshes().begin(), scene.meshes().end(), isHidden);
    if (hidden > 0)
        notes.push_back(hidden == 1 ? "1 hidden object is not in the mesh."
                                    : std::to_string(hidden) + " hidden objects are not in the mesh.");
}

// Of `mesh`, which is the made one as the file has it: the same triangles in the same order.
MeshDeviation deviationOf(Made& made, const TriangleMesh& mesh, const Scene& scene, bool angles)
{
    const auto count = static_cast<std::ptrdiff_t>(made.surfaces.parameters.size());
    std::vector<std::uint32_t> there(made.mesh.vertices.size());  // readers number vertices anew
    for (size_t k = 0; k < made.surfaces.parameters.size(); ++k)
        for (size_t corner = 0; corner < 3; ++corner)
            there[made.mesh.triangles[k][corner]] = mesh.triangles[k][corner];
    for (OutlineChord& chord : made.surfaces.chords)
        for (std::uint32_t& vertex : chord.vertices)
            vertex = there[vertex];
    made.surfaces.mesh = {mesh.vertices, {mesh.triangles.begin(), mesh.triangles.begin() + count}};
    return measuredDeviation(made.surfaces, scene, angles);
}

// Files that repeat vertices are read with one at each place: bodies that touch share it. Nothing where that
// would join vertices of one body.
std::optional<TriangleMesh> joinedBodies(const TriangleMesh& mesh)
{
    JoinedSets bodies(mesh.vertices.size());
    for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            bodies.join(corner, triangle[0]);
    MeshBuilding building;
    std::vector<std::uint32_t> numbers;
    std::set<std::pair<std::uint32_t, std::uint32_t>> taken;  // a place, and a body that has a vertex there
    for (std::uint32_t k = 0; k < mesh.vertices.size(); ++k) {
        numbers.push_back(building.weldedVertex(mesh.vertices[k]));
        if (!taken.insert({numbers.back(), bodies.find(k)}).second)
            return std::nullopt;
    }
    for (const Triangle& triangle : mesh.triangles) {
        const std::uint32_t corners[] = {numbers[triangle[0]], numbers[triangle[1]], numbers[triangle[2]]};
        building.polygon(corners);
    }
    return building.take();
}

// Compares what was read with what was meant.
Result<void> isSameMesh(const TriangleMesh& made, const TriangleMesh& back, bool repeatsVertices)
{
    const auto joined = repeatsVertices ? joinedBodies(made) : std::nullopt;
    const TriangleMesh& mesh = joined ? *joined : made;
    const MeshTopology meant = topologyOf(mesh);
    const MeshTopology read = topologyOf(back);
    if (back.triangles.size() != mesh.triangles.size() || read.edges != meant.edges ||
        read.boundaryEdges != meant.boundaryEdges || read.nonManifoldEdges != meant.nonManifoldEdges ||
        read.turnedEdges != meant.turnedEdges || read.euler != meant.euler)
        return failure(
            "What was written is read back as another mesh: vertices that are very near each other "
            "became one",
            "Choose a larger deviation, or a format with doubles: PLY, OBJ, OFF or VTP");
    return {};
}

}  // namespace

double usualDeviation(const Scene& scene)
{
    Box box;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            box.add(surfaceBounds(object->surface, object->transform));
    const double size = box.diagonal();
    return size > 0 ? size / 1000 : 1;
}

Result<MeshCounts> meshCounts(const Scene& scene, const MeshExportOptions& options)
{
    return make(scene, options).map([](const Made& made) {
        return MeshCounts{made.mesh.triangles.size(), made.mesh.vertices.size()};
    });
}

Result<MeshExportReport> exportMesh(const Scene& scene, const std::filesystem::path& path,
                                    const MeshExportOptions& options)
{
    auto made = make(scene, options);
    if (!made)
        return tl::unexpected(made.error().at(path.string()));
    TriangleMesh read;
    const auto write = [&](const std::filesystem::path& temporary) -> Result<void> {
        if (auto written = writeMeshTo(temporary, made->mesh, options.kind, scene.units());
            !written || !options.verify)
            return written;
        auto back = rereadMesh(temporary, options.kind, scene.units());
        if (!back)
            return tl::unexpected(back.error());
        read = *std::move(back);
        return isSameMesh(made->mesh, read, options.kind == MeshKind::stl || options.kind == MeshKind::glb);
    };
    if (const auto written = replaceFile(path, write); !written)
        return tl::unexpected(written.error().at(path.string()));

    MeshExportReport report;
    const MeshTopology topology = topologyOf(made->mesh);
    report.counts = {made->mesh.triangles.size(), made->mesh.vertices.size()};
    report.boundaryEdges = topology.boundaryEdges;
    report.nonManifoldEdges = topology.nonManifoldEdges;
    report.notes = made->surfaces.notes;
    noteHidden(scene, report.notes);
    if (made->asked > 0) {
        const MeshDeviation measured =
            deviationOf(*made, options.verify ? read : made->mesh, scene, options.angleDegrees.has_value());
        report.deviation = {made->asked, made->surfaces.bound + made->moved, measured.largest,
                            measured.largestAngle};
    }
    if (options.kind == MeshKind::glb)
        report.notes.push_back(noteOnUnits(scene.units()));
    return report;
}

}  // namespace knotspan::formats
