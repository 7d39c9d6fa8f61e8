// The picture that several frames make together, each in a place of its own.
#pragma once

#include <vector>

#include "renderer/frame.h"
#include "renderer/renderer.h"
#include "renderer/vulkan/buffer.h"
#include "renderer/vulkan/image.h"

namespace knotspan {

class Sheet {
public:
    Sheet(const Device& device, VkExtent2D extent);

    [[nodiscard]] VkExtent2D extent() const { return image_.extent(); }
    [[nodiscard]] Image& image() { return image_; }

    // Copies a finished picture to its place; what would stand out is left out. Both can be copied before and
    // after. Where it lies over another one's place, not in it, a new arrangement begins with nothing.
    void put(VkCommandBuffer commands, const Image& picture, const Pane& pane);

private:
    void clear(VkCommandBuffer commands);
    [[nodiscard]] bool holds(const VkRect2D& place) const;
    [[nodiscard]] bool isElsewhere(const VkRect2D& place) const;

    Image image_;
    std::vector<VkRect2D> places_;  // that have pictures; none: nothing is in it yet
};

}  // namespace knotspan
