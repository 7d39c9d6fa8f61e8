#include "renderer/stats/gpu_clock.h"

#include "model/core/check.h"

namespace knotspan {

GpuClock::GpuClock(const Device& device) : device_(device)
{
    const std::uint32_t bits = device.timestampBits();
    if (bits == 0)
        return;
    mask_ = bits >= 64 ? ~0ULL : (1ULL << bits) - 1;
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = kMostLaps + 1;
    VkQueryPool pool = VK_NULL_HANDLE;
    vkCheck(vkCreateQueryPool(device.get(), &info, nullptr, &pool), "making a clock");
    queries_ = {device.get(), pool};
    millisecondsPerTick_ = static_cast<double>(device.limits().timestampPeriod) * 1e-6;
}

void GpuClock::start(VkCommandBuffer commands)
{
    lapCount_ = 0;
    if (queries_.get() == VK_NULL_HANDLE)
        return;
    vkCmdResetQueryPool(commands, queries_.get(), 0, kMostLaps + 1);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(), 0);
}

void GpuClock::lap(VkCommandBuffer commands, GpuStage stage)
{
    if (queries_.get() == VK_NULL_HANDLE)
        return;
    check(lapCount_ < kMostLaps, "a frame has few stages");
    laps_[lapCount_++] = stage;
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(), lapCount_);
}

void GpuClock::stop(VkCommandBuffer commands)
{
    lap(commands, GpuStage::drawing);
}

std::array<std::uint64_t, GpuClock::kMostLaps + 1> GpuClock::ticks() const
{
    std::array<std::uint64_t, kMostLaps + 1> ticks{};
    if (lapCount_ > 0)
        vkCheck(vkGetQueryPoolResults(device_.get(), queries_.get(), 0, lapCount_ + 1, sizeof(ticks),
                                      ticks.data(), sizeof(std::uint64_t),
                                      VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
                "reading the clock");
    return ticks;
}

double GpuClock::between(std::uint64_t first, std::uint64_t last) const
{
    return static_cast<double>((last - first) & mask_) * millisecondsPerTick_;
}

double GpuClock::milliseconds() const
{
    const auto at = ticks();
    return between(at[0], at[lapCount_]);
}

std::array<double, kGpuStageCount> GpuClock::stageMilliseconds() const
{
    const auto at = ticks();
    std::array<double, kGpuStageCount> stages{};
    for (std::uint32_t k = 0; k < lapCount_; ++k)
        stages[static_cast<size_t>(laps_[k])] += between(at[k], at[k + 1]);
    return stages;
}

}  // namespace knotspan
