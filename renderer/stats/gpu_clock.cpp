#include "renderer/stats/gpu_clock.h"

#include <array>

namespace knotspan {

GpuClock::GpuClock(const Device& device) : device_(device)
{
    const std::uint32_t bits = device.timestampBits();
    if (bits == 0)
        return;
    mask_ = bits >= 64 ? ~0ULL : (1ULL << bits) - 1;
    VkQueryPoolCreateInfo info{VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
    info.queryType = VK_QUERY_TYPE_TIMESTAMP;
    info.queryCount = 2;
    VkQueryPool pool = VK_NULL_HANDLE;
    vkCheck(vkCreateQueryPool(device.get(), &info, nullptr, &pool), "making a clock");
    queries_ = {device.get(), pool};
    millisecondsPerTick_ = static_cast<double>(device.limits().timestampPeriod) * 1e-6;
}

void GpuClock::start(VkCommandBuffer commands) const
{
    if (queries_.get() == VK_NULL_HANDLE)
        return;
    vkCmdResetQueryPool(commands, queries_.get(), 0, 2);
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(), 0);
}

void GpuClock::stop(VkCommandBuffer commands) const
{
    if (queries_.get() != VK_NULL_HANDLE)
        vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, queries_.get(), 1);
}

double GpuClock::milliseconds() const
{
    if (queries_.get() == VK_NULL_HANDLE)
        return 0.0;
    std::array<std::uint64_t, 2> ticks{};
    vkCheck(vkGetQueryPoolResults(device_.get(), queries_.get(), 0, 2, sizeof(ticks), ticks.data(),
                                  sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
            "reading the clock");
    return static_cast<double>((ticks[1] - ticks[0]) & mask_) * millisecondsPerTick_;
}

}  // namespace knotspan
