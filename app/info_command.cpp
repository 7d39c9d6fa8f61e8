#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>

#include <nlohmann/json.hpp>

#include "app/arguments.h"
#include "app/commands.h"
#include "app/output.h"
#include "model/analysis/surface_bounds.h"
#include "model/analysis/trimmed_area.h"
#include "model/geometry/ksquad.h"
#include "model/trimming/loop_crossings.h"

namespace knotspan::app {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
    std::string file;
    bool json = false;
    bool area = false;
};

// What the surfaces take on the GPU as they are, and what they would take cut into Bezier patches.
struct Bytes {
    size_t nurbs = 0;
    size_t bezier = 0;
};

Bytes bytesOf(const Scene& scene)
{
    constexpr size_t kControlPoint = 16;  // x, y, z, w as float
    constexpr size_t kKnot = 4;
    Bytes bytes;
    for (const auto& [id, object] : scene.objects()) {
        const NurbsSurface& surface = object->surface;
        bytes.nurbs += surface.controlPoints().size() * kControlPoint;
        bytes.nurbs += (surface.knotsU().values().size() + surface.knotsV().values().size()) * kKnot;
        bytes.bezier += ksQuadCount(surface) * static_cast<size_t>(surface.degreeU() + 1) *
                        static_cast<size_t>(surface.degreeV() + 1) * kControlPoint;
    }
    return bytes;
}

// Of what is left of the visible surfaces themselves, not of their control points, and of the meshes.
Box boundsOf(const Scene& scene)
{
    Box box;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            box.add(trimmedBounds(object->surface, object->trimLoops, object->transform));
    for (const auto& [id, object] : scene.meshes())
        if (object->visible)
            for (const Vec3& vertex : object->mesh->vertices)
                box.add(transformed(vertex, object->transform));
    return box;
}

Area areaOf(const SceneObject& object)
{
    return trimmedArea(object.surface, object.trimLoops, object.transform);
}

// What was wrong with its trim loops.
std::vector<std::string> loopNotesOf(const SceneObject& object)
{
    const TrimRegion region(object.trimLoops, object.surface);
    std::vector<std::string> notes = region.report();
    for (const std::string& crossing : crossingsOf(region))
        notes.push_back(crossing);
    return notes;
}

Json describe(const SceneObject& object, size_t id, bool withArea)
{
    const NurbsSurface& surface = object.surface;
    Json json = {{"id", id},
                 {"name", object.name},
                 {"degree_u", surface.degreeU()},
                 {"degree_v", surface.degreeV()},
                 {"control_points_u", surface.countU()},
                 {"control_points_v", surface.countV()},
                 {"rational", surface.isRational()},
                 {"closed_u", surface.isClosedU()},
                 {"closed_v", surface.isClosedV()},
                 {"trimmed", !object.trimLoops.empty()},
                 {"ksquads", ksQuadCount(surface)}};
    if (!object.trimLoops.empty()) {
        json["trim_loops"] = object.trimLoops.size();
        json["trim_notes"] = loopNotesOf(object);
    }
    if (withArea) {
        const Area area = areaOf(object);
        json["area"] = area.value;
        json["area_error"] = area.error;
    }
    return json;
}

Json describe(const MeshObject& object, size_t id)
{
    const MeshTopology topology = topologyOf(*object.mesh);
    return {{"id", id},
            {"name", object.name},
            {"vertices", object.mesh->vertices.size()},
            {"triangles", object.mesh->triangles.size()},
            {"boundary_edges", topology.boundaryEdges},
            {"non_manifold_edges", topology.nonManifoldEdges},
            {"closed", topology.isClosedManifold()}};
}

Json describe(const Scene& scene, bool withArea)
{
    Json surfaces = Json::array();
    for (const auto& [id, object] : scene.objects())
        surfaces.push_back(describe(*object, surfaces.size(), withArea));
    Json bounds;  // null for an empty model
    if (const Box box = boundsOf(scene); !box.isEmpty())
        bounds = {{"low", {box.low.x, box.low.y, box.low.z}}, {"high", {box.high.x, box.high.y, box.high.z}}};
    Json meshes = Json::array();
    for (const auto& [id, mesh] : scene.meshes())
        meshes.push_back(describe(*mesh, meshes.size()));
    const Bytes bytes = bytesOf(scene);
    return {{"surfaces", surfaces},
            {"meshes", meshes},
            {"ksquads", scene.ksQuadCount()},
            {"control_points", scene.controlPointCount()},
            {"bounds", bounds},
            {"units", scene.units()},
            {"bytes_nurbs", bytes.nurbs},
            {"bytes_bezier", bytes.bezier}};
}

double mebibytes(std::uint64_t bytes)
{
    return static_cast<double>(bytes) / (1 << 20);
}

// What the import made of the file's faces; nothing to say of formats that hold what Knotspan has.
Json describe(const formats::ImportReport& report)
{
    Json refusals = Json::array();
    for (const formats::RefusedFace& face : report.refusals)
        refusals.push_back({{"name", face.name}, {"reason", face.reason}});
    return {
        {"faces", report.faces},
        {"exact", report.exact},
        {"approximated", report.approximated},
        {"approximation_error", report.approximationError},
        {"refused", report.refused},
        {"refusals", refusals},
        {"untrimmed", report.untrimmed},
        {"file_units", report.fileUnits},
        {"seconds", std::round(report.seconds * 1000) / 1000},
        {"peak_mb", report.peakBytes > 0 ? Json(std::round(mebibytes(report.peakBytes) * 10) / 10) : Json()}};
}

void printForPeople(const formats::ImportReport& report)
{
    if (report.faces > 0)
        std::cout << "of " << report.faces << " faces: " << report.exact << " exact, " << report.approximated
                  << " approximated, " << report.refused << " left out, " << report.untrimmed
                  << " without their trim curves\n";
    if (report.peakBytes > 0) {
        char line[80];
        std::snprintf(line, sizeof line, "read in %.2f s, with %.0f MiB of memory\n", report.seconds,
                      mebibytes(report.peakBytes));
        std::cout << line;
    }
}

void printMeshes(const Scene& scene)
{
    if (!scene.meshes().empty())
        std::cout << "\n   id   vertices  triangles  boundary edges  non-manifold edges  closed  name\n";
    size_t number = 0;
    for (const auto& [id, object] : scene.meshes()) {
        const MeshTopology topology = topologyOf(*object->mesh);
        char line[160];
        std::snprintf(line, sizeof line, "%5zu  %9zu  %9zu  %14zu  %18zu  %-6s  ", number++,
                      object->mesh->vertices.size(), object->mesh->triangles.size(), topology.boundaryEdges,
                      topology.nonManifoldEdges, topology.isClosedManifold() ? "yes" : "no");
        std::cout << line << object->name << '\n';
    }
}

void printArea(const Scene& scene)
{
    Area whole;
    for (const auto& [id, object] : scene.objects()) {
        const Area area = areaOf(*object);
        whole.value += area.value;
        whole.error += area.error;
    }
    char line[120];
    std::snprintf(line, sizeof line, "area %.9g (off by %.1g at most, as estimated) %s^2\n", whole.value,
                  whole.error, scene.units().c_str());
    std::cout << line;
}

void printForPeople(const Scene& scene)
{
    const Box box = boundsOf(scene);
    const Bytes bytes = bytesOf(scene);
    if (!scene.objects().empty() || scene.meshes().empty())
        std::cout << scene.objects().size() << " surfaces, " << scene.ksQuadCount() << " KSQuads, "
                  << scene.controlPointCount() << " control points\n";
    if (!scene.meshes().empty())
        std::cout << scene.meshes().size() << (scene.meshes().size() == 1 ? " mesh\n" : " meshes\n");
    if (!box.isEmpty())
        std::cout << "bounds (" << box.low.x << ", " << box.low.y << ", " << box.low.z << ") to ("
                  << box.high.x << ", " << box.high.y << ", " << box.high.z << ") " << scene.units() << '\n';
    if (!scene.objects().empty())
        std::cout << bytes.nurbs << " bytes as NURBS, " << bytes.bezier << " bytes as Bezier patches\n";
    if (!scene.objects().empty())
        std::cout << "\n   id  degree  control points   KSQuads  rational  closed  trimmed  name\n";
    size_t number = 0;
    for (const auto& [id, object] : scene.objects()) {
        const NurbsSurface& surface = object->surface;
        const std::string closed =
            std::string(surface.isClosedU() ? "u" : "") + (surface.isClosedV() ? "v" : "");
        char line[160];
        std::snprintf(line, sizeof line, "%5zu  %2d x %-2d  %6d x %-6d  %8zu  %-8s  %-6s  %-7s  ", number++,
                      surface.degreeU(), surface.degreeV(), surface.countU(), surface.countV(),
                      ksQuadCount(surface), surface.isRational() ? "yes" : "no",
                      closed.empty() ? "no" : closed.c_str(), object->trimLoops.empty() ? "no" : "yes");
        std::cout << line << object->name << '\n';
    }
    printMeshes(scene);
}

int run(const Options& options)
{
    const auto import = readImport(options.file);
    if (!import)
        return failed(import.error());
    if (options.json) {
        Json json = describe(import->scene, options.area);
        if (import->report.faces > 0)
            json["import"] = describe(import->report);
        std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
        return kDone;
    }
    printForPeople(import->scene);
    if (options.area)
        printArea(import->scene);
    printForPeople(import->report);
    return kDone;
}

}  // namespace

void addInfoCommand(CLI::App& app, int& exitCode)
{
    const auto options = std::make_shared<Options>();
    CLI::App* command =
        app.add_subcommand("info", "Say what a model holds; its bounds are those of what trim loops leave");
    addModel(*command, options->file);
    addJson(*command, options->json);
    command->add_flag("--area", options->area,
                      "Measure the surfaces, too: of trimmed ones what the loops leave");
    command->callback([options, &exitCode] { exitCode = run(*options); });
}

}  // namespace knotspan::app
