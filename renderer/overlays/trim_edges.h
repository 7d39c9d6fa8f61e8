// Smooths the borders of trimmed surfaces in a picture, by how much of each pixel they cover.
#pragma once

#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class TrimEdges {
public:
    TrimEdges(const Device& device, Bindings& bindings);

    void prepare(VkExtent2D extent);
    // Takes each pixel's colour and then each one's depth, four bytes each.
    [[nodiscard]] VkBuffer pixels() const { return pixels_.get(); }
    [[nodiscard]] VkDeviceSize depthsFrom() const { return depthsFrom_; }
    // Finds where there is something to smooth, outside of rendering, once the pixels are there.
    void find(VkCommandBuffer commands) const;
    void draw(VkCommandBuffer commands) const;

    void listMemory(std::vector<HeldMemory>& to) const;

private:
    Bindings& bindings_;
    Pipeline tiles_;
    Pipeline picture_;
    Buffer pixels_;
    VkDeviceSize depthsFrom_ = 0;
    std::uint32_t tileCount_ = 0;
};

}  // namespace knotspan
