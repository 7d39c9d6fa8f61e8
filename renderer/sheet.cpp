#include "renderer/sheet.h"

#include <algorithm>

#include "renderer/vulkan/pipeline.h"

namespace knotspan {

Sheet::Sheet(const Device& device, VkExtent2D extent)
    : image_(device, kColourFormat, extent,
             VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,  // an image with a view has a use for it
             VK_IMAGE_ASPECT_COLOR_BIT)
{
}

void Sheet::put(VkCommandBuffer commands, const Image& picture, const Pane& pane)
{
    constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    image_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kTransfer,
                      VK_ACCESS_2_TRANSFER_READ_BIT, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, fresh_);
    if (fresh_) {
        // What no frame fills, the lines between the views: black.
        const VkClearColorValue black{{0, 0, 0, 1}};
        const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
        vkCmdClearColorImage(commands, image_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &black, 1, &whole);
        image_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kTransfer,
                          VK_ACCESS_2_TRANSFER_WRITE_BIT, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    }
    fresh_ = false;
    const auto least = [](std::uint32_t size, int room) {
        return std::min(size, static_cast<std::uint32_t>(std::max(room, 0)));
    };
    VkImageCopy copy{};
    copy.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.dstSubresource = copy.srcSubresource;
    copy.dstOffset = {pane.x, pane.y, 0};
    copy.extent = {least(picture.extent().width, pane.sheetWidth - pane.x),
                   least(picture.extent().height, pane.sheetHeight - pane.y), 1};
    if (pane.x >= 0 && pane.y >= 0 && copy.extent.width > 0 && copy.extent.height > 0)
        vkCmdCopyImage(commands, picture.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image_.get(),
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    image_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kTransfer,
                      VK_ACCESS_2_TRANSFER_WRITE_BIT, kTransfer, VK_ACCESS_2_TRANSFER_READ_BIT);
}

}  // namespace knotspan
