#include "renderer/stats/gpu_counters.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace knotspan {

GpuCounters::GpuCounters(const Device& device, Bindings& bindings)
    : device_(device),
      bindings_(bindings),

      readBack_(device, sizeof(gpu::Counters), Buffer::Place::readBack)
{
    bindings.provide(BINDING_COUNTERS, counters_, sizeof(gpu::Counters));
    reserveCapture(0);
}

void GpuCounters::clear(VkCommandBuffer commands) const
{
    vkCmdFillBuffer(commands, counters_.get(), 0, VK_WHOLE_SIZE, 0);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void GpuCounters::fetch(VkCommandBuffer commands) const
{
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
    const VkBufferCopy all{0, 0, sizeof(gpu::Counters)};
    vkCmdCopyBuffer(commands, counters_.get(), readBack_.get(), 1, &all);
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

gpu::Counters GpuCounters::read() const
{
    gpu::Counters counters;
    std::memcpy(&counters, readBack_.mapped(), sizeof(counters));
    return counters;
}

void GpuCounters::reserveCapture(std::uint32_t vertices)
{
    capacity_ = 0;
    bindings_.provide(BINDING_CAPTURED, captured_, VkDeviceSize{vertices} * sizeof(gpu::CapturedRecord));
    capacity_ = vertices;
}

std::vector<gpu::CapturedRecord> GpuCounters::readCapture(std::uint32_t count) const
{
    std::vector<gpu::CapturedRecord> records(std::min(count, capacity_));
    if (records.empty())
        return records;
    const VkDeviceSize bytes = records.size() * sizeof(records[0]);
    const Buffer readBack(device_, bytes, Buffer::Place::readBack);
    device_.execute([&](VkCommandBuffer commands) {
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT);
        const VkBufferCopy region{0, 0, bytes};
        vkCmdCopyBuffer(commands, captured_.get(), readBack.get(), 1, &region);
        memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                      VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
    });
    std::memcpy(records.data(), readBack.mapped(), bytes);
    return records;
}

void noteErrors(FrameStats& stats, const gpu::Counters& counted, bool measured)
{
    if (counted.errorBound != 0)
        stats.errorBoundPx = std::bit_cast<float>(counted.errorBound);
    if (!measured)
        return;
    constexpr double kStep = 1.0 / 4096.0;
    const double sum = kStep * (counted.errorSum[0] + 4294967296.0 * counted.errorSum[1]);
    stats.errorPxMax = std::bit_cast<float>(counted.errorMax);
    stats.errorPixelsLost = counted.errorLost;
    stats.errorPxMean = counted.errorPixels > 0 ? sum / counted.errorPixels : 0.0;
}

}  // namespace knotspan
