#include "tests/fuzz/readers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "model/core/check.h"
#include "model/files/json_parsing.h"
#include "model/formats/bpt_format.h"
#include "model/formats/knotspan_json.h"
#include "model/formats/obj_format.h"
#include "model/mesh_files/mesh_reading.h"

namespace knotspan::fuzz {

namespace {

// Names and the direction of loops without an area may differ.
bool sameSurfaces(const Scene& a, const Scene& b)
{
    return std::equal(a.objects().begin(), a.objects().end(), b.objects().begin(), b.objects().end(),
                      [](const auto& first, const auto& second) {
                          return first.second->surface == second.second->surface &&
                                 first.second->trimLoops.size() == second.second->trimLoops.size();
                      });
}

void expectToOutlastObj(const Scene& scene)
{
    if (scene.objects().empty())  // polygons alone, which go out as a mesh
        return;
    std::ostringstream out;
    check(formats::writeObj(scene, out).has_value(), "a scene that was read can be written");
    const auto again = formats::sceneFromObj(out.str());
    check(again.has_value() && sameSurfaces(scene, again->scene), "OBJ files keep surfaces");
}

std::string sentenceOf(const Result<formats::Import>& import)
{
    if (!import)
        return import.error().sentence();
    expectToOutlastObj(import->scene);
    return {};
}

std::string objectWithLoops(std::string_view loops)
{
    std::string text =
        R"({"format":"knotspan","version":1,"units":"mm","objects":[{"name":"","colour":[0,0,0],)"
        R"("transform":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"visible":true,"surface":{"degree_u":1,)"
        R"("degree_v":1,"knots_u":[0,0,1,1],"knots_v":[0,0,1,1],"control_points":)"
        R"([[0,0,0,1],[0,1,0,1],[1,0,0,1],[1,1,0,1]]},"trim_loops":)";
    return text.append(loops).append("}]}");
}

std::string surfaceWithCurves(std::string_view curves)
{
    std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvp 0 0 1\nvp .5 .1 2\nvp 1 0 3\nvp 1 1\nvp 0 1\n";
    text.append(curves).append(
        "\ncstype bspline\ndeg 1 1\nsurf 0 1 0 1 1 2 3 4\nparm u 0 0 1 1\nparm v 0 0 1 1\n");
    return text.append("trim 0 1 1\nhole 0 1 2\nend\n");
}

void expectPointsOn(const TrimCurve& curve)
{
    const double start = curve.knots().domainStart();
    const double end = curve.knots().domainEnd();
    for (const double t : {start, end, start / 2 + end / 2, -std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
        const Vec2 at = curve.evaluate(t);
        check(std::isfinite(at.x) && std::isfinite(at.y), "a trimming curve has points everywhere");
        (void)curve.derivative(t);
    }
}

void expectSound(const TriangleMesh& mesh)
{
    check(!mesh.triangles.empty(), "a mesh has triangles");
    for (const Vec3& vertex : mesh.vertices)
        check(std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.z),
              "vertices are finite");
    for (const auto& [a, b, c] : mesh.triangles)
        check(std::max({a, b, c}) < mesh.vertices.size() && a != b && b != c && c != a,
              "triangles have three vertices");
    (void)topologyOf(mesh);
}

std::string sentenceOf(const Result<TriangleMesh>& mesh)
{
    if (!mesh)
        return mesh.error().sentence();
    expectSound(*mesh);
    return {};
}

void expectPointsOnLoops(const Scene& scene)
{
    for (const auto& [id, object] : scene.objects())
        for (const TrimLoop& loop : object->trimLoops)
            for (const TrimCurve& curve : loop.curves)
                expectPointsOn(curve);
}

}  // namespace

std::string readObj(std::string_view text)
{
    return sentenceOf(formats::sceneFromObj(text));
}

std::string readBpt(std::string_view text)
{
    return sentenceOf(formats::sceneFromBpt(text));
}

std::string readKnotspan(std::string_view text)
{
    const auto json = formats::parsedJson(std::string(text));
    if (!json)
        return json.error().sentence();
    const auto scene = formats::sceneFromJson(*json);
    if (!scene)
        return scene.error().sentence();
    for (const auto& [id, object] : scene->objects()) {
        const auto again = formats::parsedJson(
            R"({"format":"knotspan","version":1,"units":"mm","objects":[)" + formats::textOf(*object) + "]}");
        check(again.has_value(), "what is written can be parsed");
        const auto back = formats::sceneFromJson(*again);
        check(back.has_value() && back->objects().begin()->second->surface == object->surface &&
                  back->objects().begin()->second->trimLoops == object->trimLoops,
              "files keep surfaces");
    }
    return {};
}

std::string readTrimLoops(std::string_view text)
{
    if (const auto json = formats::parsedJson(objectWithLoops(text)))
        if (const auto scene = formats::sceneFromJson(*json)) {
            expectPointsOnLoops(*scene);
            return readKnotspan(objectWithLoops(text));
        }
    const auto import = formats::sceneFromObj(surfaceWithCurves(text));
    if (import)
        expectPointsOnLoops(import->scene);
    return sentenceOf(import);
}

std::string readStl(std::string_view text)
{
    return sentenceOf(formats::meshFromStl(text));
}

std::string readPly(std::string_view text)
{
    return sentenceOf(formats::meshFromPly(text));
}

std::string readOff(std::string_view text)
{
    return sentenceOf(formats::meshFromOff(text));
}

std::string readGltf(std::string_view text)
{
    // Not there: what the file names beside itself is not looked for anywhere else.
    const auto scene = formats::sceneFromGltf(text, "/nonexistent");
    if (!scene)
        return scene.error().sentence();
    for (const auto& [id, object] : scene->meshes())
        expectSound(*object->mesh);
    return {};
}

}  // namespace knotspan::fuzz
