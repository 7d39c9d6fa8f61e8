// The counters that the stages add to, and the vertices they note down when a test asks.
#pragma once

#include "renderer/stats/frame_stats.h"
#include "renderer/vulkan/pipeline.h"
#include "shaders/shared/layouts.h"

namespace knotspan {

class GpuCounters {
public:
    GpuCounters(const Device& device, Bindings& bindings);

    void clear(VkCommandBuffer commands) const;  // before the frame's work
    void fetch(VkCommandBuffer commands) const;  // after it
    [[nodiscard]] gpu::Counters read() const;    // after the commands are done

    [[nodiscard]] VkBuffer buffer() const { return counters_.get(); }

    // Room for so many captured vertices; 0 gives it back.
    void reserveCapture(std::uint32_t vertices);
    [[nodiscard]] std::uint32_t captureCapacity() const { return capacity_; }
    [[nodiscard]] std::vector<gpu::CapturedRecord> readCapture(std::uint32_t count) const;

private:
    const Device& device_;
    Bindings& bindings_;
    Buffer counters_;
    Buffer readBack_;
    Buffer captured_;
    std::uint32_t capacity_ = 0;
};

// How far the picture may be off, where the sampling rule said so; and how far it is, where the fragment
// stage measured it (`measured`).
void noteErrors(FrameStats& stats, const gpu::Counters& counted, bool measured);

}  // namespace knotspan
