// What a frame cost and did: one struct, and one table of its fields that the stats panel, the JSON writer
// and the tests walk, so that a new figure is one member and one line.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "model/core/spread.h"
#include "renderer/culling/cull_modes.h"
#include "renderer/stats/gpu_clock.h"
#include "renderer/stats/processor_clock.h"

namespace knotspan {

// KSQuads by the name of the culling mode that dropped them.
using ModeCounts = std::vector<std::pair<std::string, std::uint64_t>>;

struct FrameStats {
    std::string device;
    std::string path;
    std::vector<std::string> culling;
    bool cullingFrozen = false;  // its camera stands still (Frame::cullingCamera)
    std::string sampling;
    std::string evaluator;  // the one in use, never "auto"
    double tolerancePx = 0;
    int width = 0;
    int height = 0;
    std::uint64_t surfaces = 0;
    std::uint64_t surfacesTrimmed = 0;      // of which trim loops leave a part
    std::optional<std::string> drawnWhole;  // whose trim loops cannot be followed, and why; a sentence
    std::uint64_t ksquads = 0;
    std::uint64_t ksquadsDrawn = 0;
    std::array<std::uint64_t, kCullModeCount> ksquadsCulled{};  // by the first mode that said so
    // Of those: what faces the eye within the picture, whether or not something hides it. Only where asked
    // for (Frame::countWrongCulls), of the modes that are on and that drop by facing or place.
    std::optional<ModeCounts> wronglyCulled;
    std::uint64_t ksdice = 0;
    std::uint64_t triangles = 0;
    std::optional<std::uint64_t> trianglesCulled;  // of those, before they were rasterized (evs)
    std::uint64_t evaluations = 0;                 // surface points evaluated to place vertices
    // Along borders that are not oversampled because a friend lies there; of rules that look at friends.
    std::optional<std::uint64_t> samplesSaved;
    // Points of KSQuads' edges, each once a KSQuad, that were evaluated for the neighbour who owns them and
    // not again for the KSQuad's own normal, because the surface is smooth there. Of paths that draw tiles.
    std::optional<std::uint64_t> normalsShared;
    // Of the path mesh: its mesh groups, and which share of their threads' turns made a vertex.
    std::optional<std::uint64_t> meshGroups;
    std::optional<double> busyLanes;
    std::optional<std::string> pathLimit;  // what of the device holds the path back, as a sentence
    std::uint64_t frames = 1;
    // Over the frames of a run.
    Spread cpuMs;    // preparing (taking over the model's changes too) and recording, without waiting
    FrameWork work;  // of the last frame: for benchmarks, no figure of the table
    Spread gpuMs;    // from the device's timestamps
    std::array<Spread, kGpuStageCount> stageMs;  // parts of it
    std::uint64_t uploadBytesFirst = 0;
    std::uint64_t uploadBytesPerFrame = 0;
    std::uint64_t deviceBytes = 0;
    // How far the picture is from the exact surfaces; only of frames that measure it (Shading::error).
    std::optional<double> errorPxMax;
    std::optional<double> errorPxMean;
    std::optional<std::uint64_t> errorPixelsLost;  // measured by their place alone (error_surface.glsl)
    std::optional<double> errorBoundPx;  // what the sampling rule promised, where it promises anything
    // What the ends of the ramp stand for, of shadings that show numbers: curvature, degrees of draft,
    // deviation.
    std::optional<double> rampLow;
    std::optional<double> rampHigh;
    std::optional<std::uint64_t> leakPixels;  // background seen through a closed model (leak_count.h)
};

// Empty (the first kind): not measured, or not of this path. JSON leaves the key out then.
using StatValue = std::variant<std::monostate, std::string, std::vector<std::string>, double, std::uint64_t,
                               Spread, std::array<std::uint64_t, kCullModeCount>, ModeCounts>;

struct StatField {
    std::string name;   // the key in JSON: a contract
    std::string label;  // for people
    std::string unit;   // "px", "ms", "bytes", "KSQuads" or empty
    StatValue (*get)(const FrameStats&);
};

[[nodiscard]] const std::vector<StatField>& statFields();

// The figures of a run of frames, oldest first: times as least, median and most, bytes as the first frame's
// and the most that any later one sent, counts and errors of the last frame. At least one frame.
[[nodiscard]] FrameStats combined(const std::vector<FrameStats>& frames);

// The value as a person reads it: 15,000; 3.2 / 3.4 / 5.0 ms; 1.5 MB; "not measured", or "none" of
// what has no unit.
[[nodiscard]] std::string display(const StatField& field, const FrameStats& stats);

// The whole as one JSON object.
[[nodiscard]] std::string toJson(const FrameStats& stats);

}  // namespace knotspan
