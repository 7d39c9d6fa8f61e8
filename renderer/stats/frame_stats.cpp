#include "renderer/stats/frame_stats.h"

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "model/core/check.h"

namespace knotspan {

namespace {

std::string grouped(std::uint64_t value)
{
    std::string digits = std::to_string(value);
    for (int at = static_cast<int>(digits.size()) - 3; at > 0; at -= 3)
        digits.insert(static_cast<size_t>(at), ",");
    return digits;
}

std::string printed(const char* format, double value)
{
    char text[64];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

std::string bytesText(std::uint64_t bytes)
{
    if (bytes < 1024)
        return std::to_string(bytes) + " B";
    if (bytes < 1024 * 1024)
        return printed("%.1f KB", static_cast<double>(bytes) / 1024.0);
    return printed("%.1f MB", static_cast<double>(bytes) / (1024.0 * 1024.0));
}

// Overloads for the kinds of value, as text and as JSON.
struct AsText {
    const StatField& field;

    std::string operator()(std::monostate) const { return field.unit.empty() ? "none" : "not measured"; }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const std::vector<std::string>& words) const
    {
        std::string text;
        for (const std::string& word : words)
            text += (text.empty() ? "" : ", ") + word;
        return text;
    }
    std::string operator()(double value) const { return printed("%g", value) + suffix(); }
    std::string operator()(std::uint64_t value) const
    {
        return field.unit == "bytes" ? bytesText(value) : grouped(value) + suffix();
    }
    std::string operator()(const Spread& ms) const
    {
        if (ms.min == ms.max)
            return printed("%.2f", ms.median) + suffix();
        return printed("%.2f", ms.min) + " / " + printed("%.2f", ms.median) + " / " +
               printed("%.2f", ms.max) + suffix();
    }
    std::string operator()(const std::array<std::uint64_t, kCullModeCount>& culled) const
    {
        std::string text;
        for (size_t mode = 0; mode < culled.size(); ++mode)
            if (culled[mode] > 0)
                text += (text.empty() ? "" : ", ") + cullModes()[mode].name + " " + grouped(culled[mode]);
        return text.empty() ? "0" : text;
    }
    std::string operator()(const ModeCounts& counts) const
    {
        std::string text;
        for (const auto& [mode, count] : counts)
            text += (text.empty() ? "" : ", ") + mode + " " + grouped(count);
        return text.empty() ? "nothing to count" : text;
    }
    [[nodiscard]] std::string suffix() const { return field.unit.empty() ? "" : " " + field.unit; }
};

struct AsJson {
    nlohmann::ordered_json operator()(std::monostate) const { return nullptr; }
    nlohmann::ordered_json operator()(const Spread& ms) const
    {
        return {{"min", ms.min}, {"median", ms.median}, {"max", ms.max}};
    }
    nlohmann::ordered_json operator()(const std::array<std::uint64_t, kCullModeCount>& culled) const
    {
        nlohmann::ordered_json object = nlohmann::ordered_json::object();
        for (size_t mode = 0; mode < culled.size(); ++mode)
            object[cullModes()[mode].name] = culled[mode];
        return object;
    }
    nlohmann::ordered_json operator()(const ModeCounts& counts) const
    {
        nlohmann::ordered_json object = nlohmann::ordered_json::object();
        for (const auto& [mode, count] : counts)
            object[mode] = count;
        return object;
    }
    template <class T>
    nlohmann::ordered_json operator()(const T& value) const
    {
        return value;
    }
};

template <class T>
StatValue valueOf(const T& value)
{
    return value;
}

template <class T>
StatValue valueOf(const std::optional<T>& measured)
{
    return measured ? StatValue(*measured) : StatValue();
}

}  // namespace

const std::vector<StatField>& statFields()
{
#define KNOTSPAN_FIELD(key, label, unit, member)                                             \
    {                                                                                        \
        key, label, unit, [](const FrameStats& s) -> StatValue { return valueOf(s.member); } \
    }
    static const std::vector<StatField> fields = {
        KNOTSPAN_FIELD("device", "Device", "", device),
        KNOTSPAN_FIELD("path", "Path", "", path),
        KNOTSPAN_FIELD("culling", "Culling", "", culling),
        KNOTSPAN_FIELD("sampling", "Sampling", "", sampling),
        KNOTSPAN_FIELD("evaluator", "Evaluator", "", evaluator),
        KNOTSPAN_FIELD("tolerance_px", "Tolerance", "px", tolerancePx),
        {"width", "Width", "px", [](const FrameStats& s) -> StatValue { return std::uint64_t(s.width); }},
        {"height", "Height", "px", [](const FrameStats& s) -> StatValue { return std::uint64_t(s.height); }},
        KNOTSPAN_FIELD("surfaces", "Surfaces", "", surfaces),
        KNOTSPAN_FIELD("surfaces_trimmed", "of those trimmed", "", surfacesTrimmed),
        KNOTSPAN_FIELD("drawn_whole", "Drawn whole", "", drawnWhole),
        KNOTSPAN_FIELD("ksquads", "KSQuads", "", ksquads),
        KNOTSPAN_FIELD("ksquads_drawn", "KSQuads drawn", "", ksquadsDrawn),
        KNOTSPAN_FIELD("ksquads_culled", "KSQuads culled", "", ksquadsCulled),
        KNOTSPAN_FIELD("wrongly_culled", "Wrongly culled", "KSQuads", wronglyCulled),
        KNOTSPAN_FIELD("ksdice", "KSDice", "", ksdice),
        KNOTSPAN_FIELD("triangles", "Triangles", "", triangles),
        KNOTSPAN_FIELD("triangles_culled", "Triangles culled", "", trianglesCulled),
        KNOTSPAN_FIELD("evaluations", "Evaluations", "", evaluations),
        KNOTSPAN_FIELD("samples_saved", "Saved by friends", "", samplesSaved),
        KNOTSPAN_FIELD("normals_shared", "Shared normals", "", normalsShared),
        KNOTSPAN_FIELD("mesh_groups", "Mesh groups", "", meshGroups),
        KNOTSPAN_FIELD("busy_lanes", "Busy lanes", "", busyLanes),
        KNOTSPAN_FIELD("path_limit", "Limit", "", pathLimit),
        KNOTSPAN_FIELD("frames", "Frames", "", frames),
        KNOTSPAN_FIELD("cpu_ms", "CPU", "ms", cpuMs),
        KNOTSPAN_FIELD("gpu_ms", "GPU", "ms", gpuMs),
        KNOTSPAN_FIELD("gpu_culling_ms", "of that culling", "ms", stageMs[size_t(GpuStage::culling)]),
        KNOTSPAN_FIELD("gpu_sampling_ms", "sampling", "ms", stageMs[size_t(GpuStage::sampling)]),
        KNOTSPAN_FIELD("gpu_drawing_ms", "drawing", "ms", stageMs[size_t(GpuStage::drawing)]),
        KNOTSPAN_FIELD("upload_bytes_first", "First upload", "bytes", uploadBytesFirst),
        KNOTSPAN_FIELD("upload_bytes_per_frame", "Upload a frame", "bytes", uploadBytesPerFrame),
        KNOTSPAN_FIELD("device_bytes", "Device memory", "bytes", deviceBytes),
        KNOTSPAN_FIELD("error_px_max", "Largest error", "px", errorPxMax),
        KNOTSPAN_FIELD("error_px_mean", "Mean error", "px", errorPxMean),
        KNOTSPAN_FIELD("error_pixels_lost", "Too thin to tell", "px", errorPixelsLost),
        KNOTSPAN_FIELD("error_bound_px", "Promised error", "px", errorBoundPx),
        KNOTSPAN_FIELD("ramp_low", "Bluest at", "", rampLow),
        KNOTSPAN_FIELD("ramp_high", "Most orange at", "", rampHigh),
        KNOTSPAN_FIELD("leak_pixels", "Leaks", "px", leakPixels),
    };
#undef KNOTSPAN_FIELD
    return fields;
}

FrameStats combined(const std::vector<FrameStats>& frames)
{
    check(!frames.empty(), "there is a frame to report");
    FrameStats stats = frames.back();
    stats.frames = frames.size();
    std::vector<double> cpu;
    std::vector<double> gpu;
    stats.uploadBytesFirst = frames.front().uploadBytesFirst;
    stats.uploadBytesPerFrame = 0;
    for (const FrameStats& frame : frames) {
        cpu.push_back(frame.cpuMs.median);
        gpu.push_back(frame.gpuMs.median);
        stats.uploadBytesPerFrame = std::max(stats.uploadBytesPerFrame, frame.uploadBytesPerFrame);
    }
    stats.cpuMs = spreadOf(std::move(cpu));
    stats.gpuMs = spreadOf(std::move(gpu));
    for (size_t stage = 0; stage < kGpuStageCount; ++stage) {
        std::vector<double> part;
        for (const FrameStats& frame : frames)
            part.push_back(frame.stageMs[stage].median);
        stats.stageMs[stage] = spreadOf(std::move(part));
    }
    return stats;
}

std::string display(const StatField& field, const FrameStats& stats)
{
    return std::visit(AsText{field}, field.get(stats));
}

std::string toJson(const FrameStats& stats)
{
    nlohmann::ordered_json object;
    for (const StatField& field : statFields()) {
        const StatValue value = field.get(stats);
        if (!std::holds_alternative<std::monostate>(value))
            object[field.name] = std::visit(AsJson{}, value);
    }
    return object.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace knotspan
