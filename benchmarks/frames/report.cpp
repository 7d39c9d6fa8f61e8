#include "benchmarks/frames/report.h"

#include <cstdio>

#include <nlohmann/json.hpp>

namespace knotspan::benchmarks {

namespace {

using Json = nlohmann::ordered_json;

template <class... Values>
std::string printed(const char* format, Values... values)
{
    char text[400];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

const char* nameOf(Deformation motion)
{
    return deformationNames()[static_cast<size_t>(motion)].c_str();
}

std::string rowText(const OrbitRow& row)
{
    const std::string start =
        printed("| %s | %s | %s | %s |", row.sample.c_str(), pathInfo(row.path).name.c_str(),
                nameOf(row.motion), row.culling.c_str());
    if (!row.unavailable.empty())
        return start + " not measured: " + row.unavailable + " |\n";
    return start + printed(" %.2f | %.2f + %.2f + %.2f | %.2f | %.3f | %.3f | %.0f of %llu | %.0f | %.0f |\n",
                           row.gpuMs.median, row.stageMs[0].median, row.stageMs[1].median,
                           row.stageMs[2].median, row.cpuMs.median, row.gpuShare.median,
                           row.frameShare.median, row.ksquadsDrawn.median,
                           static_cast<unsigned long long>(row.ksquads), row.evaluations.median,
                           row.triangles.median);
}

Json jsonOf(const Spread& spread)
{
    return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}};
}

Json jsonOf(const OrbitRow& row)
{
    Json json{{"sample", row.sample},
              {"path", pathInfo(row.path).name},
              {"deform", nameOf(row.motion)},
              {"culling_asked", row.culling}};
    if (!row.unavailable.empty()) {
        json["unavailable"] = row.unavailable;
        return json;
    }
    Json culled;
    for (size_t mode = 0; mode < kCullModeCount; ++mode)
        culled[cullModes()[mode].name] = jsonOf(row.culled[mode]);
    json.update({{"culling", row.inForce},
                 {"gpu_ms", jsonOf(row.gpuMs)},
                 {"gpu_culling_ms", jsonOf(row.stageMs[static_cast<size_t>(GpuStage::culling)])},
                 {"gpu_sampling_ms", jsonOf(row.stageMs[static_cast<size_t>(GpuStage::sampling)])},
                 {"gpu_drawing_ms", jsonOf(row.stageMs[static_cast<size_t>(GpuStage::drawing)])},
                 {"cpu_ms", jsonOf(row.cpuMs)},
                 {"gpu_share", jsonOf(row.gpuShare)},
                 {"frame_share", jsonOf(row.frameShare)},
                 {"ksquads", row.ksquads},
                 {"ksquads_drawn", jsonOf(row.ksquadsDrawn)},
                 {"ksquads_culled", std::move(culled)},
                 {"evaluations", jsonOf(row.evaluations)},
                 {"triangles", jsonOf(row.triangles)}});
    return json;
}

}  // namespace

std::string tableOf(const std::string& device, const OrbitRequest& request, const std::vector<OrbitRow>& rows)
{
    std::string text = device +
                       printed(", %d by %d pixels, %g px, medians of an orbit of %d views\n\n", request.width,
                               request.height, request.tolerancePx, request.views) +
                       "| sample | path | deform | culling | gpu ms | culling + sampling + drawing | cpu ms "
                       "| gpu, share | frame, share | KSQuads drawn | "
                       "evaluations | triangles |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const OrbitRow& row : rows)
        text += rowText(row);
    return text + "\nShares are of the first set's time, view by view; a frame is gpu and cpu together.\n";
}

std::string jsonOf(const std::string& device, const OrbitRequest& request, const std::vector<OrbitRow>& rows)
{
    Json list = Json::array();
    for (const OrbitRow& row : rows)
        list.push_back(jsonOf(row));
    const Json json{{"device", device},         {"width", request.width},
                    {"height", request.height}, {"tolerance_px", request.tolerancePx},
                    {"views", request.views},   {"rows", std::move(list)}};
    return json.dump(2) + "\n";
}

}  // namespace knotspan::benchmarks
