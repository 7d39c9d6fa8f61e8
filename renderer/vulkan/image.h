// An image of the renderer's own to draw into, with its view.
#pragma once

#include "renderer/vulkan/device_memory.h"

namespace knotspan {

class Image {
public:
    Image() = default;
    Image(const Device& device, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
          VkImageAspectFlags aspect);

    [[nodiscard]] VkImage get() const { return image_.get(); }
    [[nodiscard]] VkImageView view() const { return view_.get(); }
    [[nodiscard]] VkExtent2D extent() const { return extent_; }

    // Waits for `before` and makes the image usable as `layout` for `after`. The old content is kept unless
    // the image is `fresh`.
    void transition(VkCommandBuffer commands, VkImageLayout layout, VkPipelineStageFlags2 before,
                    VkAccessFlags2 written, VkPipelineStageFlags2 after, VkAccessFlags2 access,
                    bool fresh = false);

private:
    DeviceMemory memory_;  // outlives the image in it
    DeviceHandle<VkImage, vkDestroyImage> image_;
    ImageView view_;
    VkExtent2D extent_{};
    VkImageAspectFlags aspect_ = 0;
    VkImageLayout layout_ = VK_IMAGE_LAYOUT_UNDEFINED;
};

// The barrier that transition() records, for images that are not ours (a swapchain's).
void imageBarrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, VkImageLayout from,
                  VkImageLayout to, VkPipelineStageFlags2 before, VkAccessFlags2 written,
                  VkPipelineStageFlags2 after, VkAccessFlags2 access);

}  // namespace knotspan
