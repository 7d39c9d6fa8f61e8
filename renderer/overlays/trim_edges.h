// Smooths the borders of trimmed surfaces in a picture, by how much of each pixel they cover.
#pragma once

#include <map>

#include "renderer/scene/held_memory.h"
#include "renderer/vulkan/pipeline.h"

namespace knotspan {

class TrimEdges {
public:
    TrimEdges(const Device& device, Bindings& bindings);

    void prepare(VkExtent2D extent, Specialization specialization);
    // Takes each pixel's colour, from there on each one's depth, and from there on what each shows.
    [[nodiscard]] VkBuffer pixels() const { return pixels_.get(); }
    [[nodiscard]] VkDeviceSize depthsFrom() const { return sizeof(std::uint32_t) * pixelCount_; }
    [[nodiscard]] VkDeviceSize shownFrom() const { return 2 * depthsFrom(); }
    // Smooths the pixels' colours there, outside of rendering; then they can be copied.
    void record(VkCommandBuffer commands) const;

    void listMemory(std::vector<HeldMemory>& to) const;

private:
    const Device& device_;
    Bindings& bindings_;
    Pipeline find_;
    std::map<Specialization, Pipeline> codes_;
    Specialization specialization_;
    Pipeline blend_;
    Pipeline put_;
    Buffer pixels_;  // as drawn_pixels.glsl has them
    VkDeviceSize pixelCount_ = 0;
    std::uint32_t tileCount_ = 0;  // of the picture
};

}  // namespace knotspan
