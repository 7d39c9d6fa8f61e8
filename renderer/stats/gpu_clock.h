// How long the device took, from timestamps around a frame and between its stages.
#pragma once

#include <array>

#include "renderer/vulkan/device.h"

namespace knotspan {

enum class GpuStage { culling, sampling, drawing };
constexpr size_t kGpuStageCount = 3;

class GpuClock {
public:
    explicit GpuClock(const Device& device);

    void start(VkCommandBuffer commands);
    // What was recorded since the start or the last lap was this stage's. Not within a rendering.
    void lap(VkCommandBuffer commands, GpuStage stage);
    void stop(VkCommandBuffer commands);  // the rest is drawing
    // After the commands are done; 0 where the device has no timestamps.
    [[nodiscard]] double milliseconds() const;
    [[nodiscard]] std::array<double, kGpuStageCount> stageMilliseconds() const;

private:
    static constexpr std::uint32_t kMostLaps = 8;

    [[nodiscard]] std::array<std::uint64_t, kMostLaps + 1> ticks() const;
    [[nodiscard]] double between(std::uint64_t first, std::uint64_t last) const;

    const Device& device_;
    QueryPool queries_;
    double millisecondsPerTick_ = 0;
    std::uint64_t mask_ = 0;  // of the bits that the device counts with
    std::array<GpuStage, kMostLaps> laps_{};
    std::uint32_t lapCount_ = 0;
};

}  // namespace knotspan
