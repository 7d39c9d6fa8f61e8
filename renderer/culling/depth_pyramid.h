// What the picture shows so far, as farthest depths in levels (shaders/culling/depth_pyramid.glsl): what
// culling by occlusion looks at between its two halves.
#pragma once

#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class DepthPyramid {
public:
    DepthPyramid(const Device& device, Bindings& bindings);

    void prepare(VkExtent2D extent);

    // Level 0: a number for each pixel, rows without gaps.
    [[nodiscard]] VkBuffer pixels() const { return depths_.get(); }
    // Records the making of the other levels, once level 0 has been copied. Bindings are set for compute;
    // `level` is where stages read which one is to be made.
    void record(VkCommandBuffer commands, VkBuffer counters, VkDeviceSize level) const;
    void listMemory(std::vector<HeldMemory>& to) const;

private:
    Bindings& bindings_;
    Pipeline reduce_;
    Buffer depths_;
    std::vector<VkExtent2D> levels_;
};

}  // namespace knotspan
