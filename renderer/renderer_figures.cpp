// What a frame cost and did, from what was counted and timed.
#include "renderer/renderer_parts.h"

#include <algorithm>

namespace knotspan {

namespace {

// A counter of two words.
std::uint64_t wide(const gpu::uint (&words)[2])
{
    return words[0] + (std::uint64_t{words[1]} << 32U);
}

std::string refusalOf(const GpuScene::Trims& trims)
{
    return (trims.refused == 1 ? "1 surface is" : std::to_string(trims.refused) + " surfaces are") +
           " drawn without trim loops: " + trims.refusal;
}

}  // namespace

std::uint32_t judgedBits(const Frame& frame, const SurfacePath& path, SamplingRule rule)
{
    return frame.countWrongCulls ? path.followed(frame.culling.bits, rule) & CULL_JUDGED : 0;
}

std::optional<ModeCounts> Renderer::Parts::wronglyCulled(const Frame& frame, const SurfacePath& path,
                                                         SamplingRule rule) const
{
    if (!frame.countWrongCulls)
        return std::nullopt;
    ModeCounts counts;
    const std::uint32_t judged = judgedBits(frame, path, rule);
    for (size_t mode = 0; mode < kCullModeCount; ++mode)
        if ((judged >> mode & 1U) != 0)
            counts.emplace_back(cullModes()[mode].name, counted_.wronglyCulled[mode]);
    return counts;
}

FrameStats Renderer::Parts::statsOf(const Frame& frame, const SurfacePath& path, SamplingRule rule,
                                    VkDeviceSize uploaded)
{
    FrameStats stats;
    stats.device = device.name();
    stats.path = pathInfo(frame.path).name;
    stats.cullingFrozen = frame.cullingCamera.has_value();
    stats.culling = names(stats.cullingFrozen ? noted_->culling : frame.culling);
    stats.sampling = name(rule);
    stats.evaluator = evaluatorInfo(scene.evaluator()).name;
    stats.tolerancePx = frame.tolerancePx;
    stats.width = frame.width;
    stats.height = frame.height;
    stats.surfaces = scene.residents().size();
    stats.surfacesTrimmed = scene.trims().trimmed;
    if (scene.trims().refused > 0)
        stats.drawnWhole = refusalOf(scene.trims());
    stats.ksquads = scene.ksquadCount();
    stats.ksquadsDrawn = counted_.drawn;
    std::copy(std::begin(counted_.culled), std::end(counted_.culled), stats.ksquadsCulled.begin());
    stats.wronglyCulled = stats.cullingFrozen ? noted_->wronglyCulled : wronglyCulled(frame, path, rule);
    stats.ksdice = wide(counted_.ksdice);
    stats.triangles = wide(counted_.triangles);
    stats.evaluations = wide(counted_.evaluations);
    if (path.asksForFriends(rule))
        stats.samplesSaved = wide(counted_.samplesSaved);
    if (path.tiles())
        stats.normalsShared = wide(counted_.normalsShared);
    if ((frame.culling.bits & CULL_DICE) != 0)
        stats.trianglesCulled = wide(counted_.trianglesCulled);
    if (counted_.meshGroups > 0) {
        stats.meshGroups = counted_.meshGroups;
        stats.busyLanes =
            static_cast<double>(stats.evaluations) / static_cast<double>(wide(counted_.laneSlots));
    }
    if (const std::string limit = path.limit(); !limit.empty())
        stats.pathLimit = limit;
    noteErrors(stats, counted_, frame.shading == Shading::error);
    if (frame.shading == Shading::curvature || frame.shading == Shading::draft ||
        frame.shading == Shading::deviation) {
        stats.rampLow = frameRecord_->lookRange.x;
        stats.rampHigh = frameRecord_->lookRange.y;
    }
    stats.cpuMs = {cpuMs_, cpuMs_, cpuMs_};
    const double gpuMs = clock.milliseconds();
    stats.gpuMs = {gpuMs, gpuMs, gpuMs};
    const auto stages = clock.stageMilliseconds();
    for (size_t stage = 0; stage < kGpuStageCount; ++stage)
        stats.stageMs[stage] = {stages[stage], stages[stage], stages[stage]};
    if (std::exchange(rebuiltForVerdicts_, false) || scene.takeRebuilt())
        firstUpload_ = uploaded;
    else
        stats.uploadBytesPerFrame = uploaded;
    stats.uploadBytesFirst = firstUpload_;
    stats.deviceBytes = device.allocatedBytes;
    return stats;
}

}  // namespace knotspan
