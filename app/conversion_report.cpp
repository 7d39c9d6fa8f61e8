#include <cmath>
#include <sstream>

#include <nlohmann/json.hpp>

#include "app/conversion.h"

namespace knotspan::app {

namespace {

using Json = nlohmann::ordered_json;

double rounded(double number, double perUnit)
{
    return std::round(number * perUnit) / perUnit;
}

void add(Json& json, const formats::MeshExportReport& mesh)
{
    json["triangles"] = mesh.counts.triangles;
    json["vertices"] = mesh.counts.vertices;
    json["boundary_edges"] = mesh.boundaryEdges;
    json["non_manifold_edges"] = mesh.nonManifoldEdges;
    if (mesh.deviation)
        json["deviation"] = {{"asked", mesh.deviation->asked},
                             {"bound", mesh.deviation->bound},
                             {"measured", mesh.deviation->measured},
                             {"kept", mesh.deviation->isKept()}};
}

}  // namespace

std::string jsonOf(const ConversionReport& report)
{
    Json json{{"input", report.input},
              {"output", report.output},
              {"ok", !report.error},
              {"error", report.error ? Json(report.error->sentence()) : Json()},
              {"seconds", rounded(report.seconds, 1000)},
              {"peak_mb", rounded(report.peakMebibytes, 10)}};
    if (report.import) {
        json["faces"] = report.import->faces;
        json["exact"] = report.import->exact;
        json["approximated"] = report.import->approximated;
        json["refused"] = report.import->refused;
    }
    if (report.mesh)
        add(json, *report.mesh);
    if (report.largestDifference)
        json["verify"] = {{"largest_difference", *report.largestDifference}};
    if (report.isMeshVerified)
        json["verify"] = {{"same_mesh", true}};
    json["notes"] = report.notes;
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string sentenceOf(const ConversionReport& report)
{
    std::ostringstream text;
    if (report.largestDifference == 0.0)
        text << report.output << ": read back, the same model to the bit";
    else if (report.largestDifference)
        text << report.output << ": read back, off by at most " << *report.largestDifference
             << " of the model's size";
    if (!report.mesh)
        return text.str();
    const formats::MeshExportReport& mesh = *report.mesh;
    text << report.output << ": " << mesh.counts.triangles << " triangles, " << mesh.counts.vertices
         << " vertices, " << mesh.boundaryEdges << " boundary edges, " << mesh.nonManifoldEdges
         << " non-manifold edges";
    if (mesh.deviation) {
        text << "; deviation asked " << mesh.deviation->asked << ", bound " << mesh.deviation->bound
             << ", measured " << mesh.deviation->measured;
        if (mesh.deviation->angleDegrees > 0)
            text << "; normals measured " << mesh.deviation->angleDegrees << " degrees";
    }
    return text.str();
}

}  // namespace knotspan::app
