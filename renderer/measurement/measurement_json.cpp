#include "renderer/measurement/measurement_json.h"

#include <nlohmann/json.hpp>

#include "model/geometry/ksquad.h"

namespace knotspan {

namespace {

using Json = nlohmann::ordered_json;

std::string nameOf(Deformation motion)
{
    return deformationNames()[static_cast<size_t>(motion)];
}

template <class Value>
Json orNull(const std::optional<Value>& value)
{
    return value ? Json(*value) : Json(nullptr);
}

Json jsonOf(const Spread& spread)
{
    return {{"min", spread.min}, {"median", spread.median}, {"max", spread.max}};
}

Json jsonOf(const PathRow& row)
{
    Json json{{"path", pathInfo(row.path).name},
              {"tolerance_px", orNull(row.tolerancePx)},
              {"evaluator", row.measured ? row.stats.evaluator : evaluatorInfo(row.evaluator).name},
              {"deform", nameOf(row.motion)}};
    if (!row.measured) {
        json["unavailable"] =
            row.unavailable.empty() ? "The measurement was stopped before" : row.unavailable;
        return json;
    }
    json.update({{"sampling", row.stats.sampling},
                 {"frames", row.stats.frames},
                 {"frame_ms", jsonOf(row.frameMs)},
                 {"cpu_ms", jsonOf(row.stats.cpuMs)},
                 {"gpu_ms", jsonOf(row.stats.gpuMs)},
                 {"triangles", row.stats.triangles},
                 {"evaluations", row.stats.evaluations},
                 {"upload_bytes_per_frame", row.stats.uploadBytesPerFrame},
                 {"device_bytes", row.stats.deviceBytes},
                 {"error_px_max", orNull(row.stats.errorPxMax)},
                 {"error_px_mean", orNull(row.stats.errorPxMean)},
                 {"error_pixels_lost", orNull(row.stats.errorPixelsLost)},
                 {"error_bound_px", orNull(row.stats.errorBoundPx)},
                 {"leak_pixels", orNull(row.stats.leakPixels)}});
    return json;
}

}  // namespace

size_t visibleKsQuads(const Scene& scene)
{
    size_t count = 0;
    for (const auto& [id, object] : scene.objects())
        count += object->visible ? ksQuadCount(object->surface) : 0;
    return count;
}

nlohmann::ordered_json jsonOf(const PathReport& report)
{
    Json rows = Json::array();
    for (const PathRow& row : report.rows)
        rows.push_back(jsonOf(row));
    const auto ofDevice = [&](std::string DeviceInfo::*member) {
        return report.device ? Json((*report.device).*member) : Json(nullptr);
    };
    return {{"program", "knotspan " KNOTSPAN_VERSION},
            {"device", ofDevice(&DeviceInfo::name)},
            {"driver", ofDevice(&DeviceInfo::driver)},
            {"vulkan", ofDevice(&DeviceInfo::vulkan)},
            {"model", report.file},
            {"ksquads", report.ksquads},
            {"width", report.request.frame.width},
            {"height", report.request.frame.height},
            {"views", std::max<size_t>(1, report.request.flight.size())},
            {"paths", std::move(rows)}};
}

std::string textOf(const nlohmann::ordered_json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace knotspan
