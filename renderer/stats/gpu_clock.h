// How long the device took, from timestamps around a frame.
#pragma once

#include "renderer/vulkan/device.h"

namespace knotspan {

class GpuClock {
public:
    explicit GpuClock(const Device& device);

    void start(VkCommandBuffer commands) const;
    void stop(VkCommandBuffer commands) const;
    // After the commands are done; 0 where the device has no timestamps.
    [[nodiscard]] double milliseconds() const;

private:
    const Device& device_;
    QueryPool queries_;
    double millisecondsPerTick_ = 0;
    std::uint64_t mask_ = 0;  // of the bits that the device counts with
};

}  // namespace knotspan
