#include "renderer/sheet.h"

#include <algorithm>

#include "renderer/vulkan/pipeline.h"

namespace knotspan {

namespace {

constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;

bool isSame(const VkRect2D& a, const VkRect2D& b)
{
    return a.offset.x == b.offset.x && a.offset.y == b.offset.y && a.extent.width == b.extent.width &&
           a.extent.height == b.extent.height;
}

}  // namespace

Sheet::Sheet(const Device& device, VkExtent2D extent)
    : image_(device, kColourFormat, extent,
             VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,  // an image with a view has a use for it
             VK_IMAGE_ASPECT_COLOR_BIT)
{
}

bool Sheet::holds(const VkRect2D& place) const
{
    return std::any_of(places_.begin(), places_.end(),
                       [&](const VkRect2D& other) { return isSame(place, other); });
}

// Whether something overlaps that place and is not there exactly.
bool Sheet::isElsewhere(const VkRect2D& place) const
{
    const auto apart = [](std::int32_t a, std::uint32_t lengthA, std::int32_t b, std::uint32_t lengthB) {
        return a + std::int64_t{lengthA} <= b || b + std::int64_t{lengthB} <= a;
    };
    return std::any_of(places_.begin(), places_.end(), [&](const VkRect2D& other) {
        return !isSame(place, other) &&
               !apart(place.offset.x, place.extent.width, other.offset.x, other.extent.width) &&
               !apart(place.offset.y, place.extent.height, other.offset.y, other.extent.height);
    });
}

// What no frame fills, the lines between the views, is black.
void Sheet::clear(VkCommandBuffer commands)
{
    const VkClearColorValue black{{0, 0, 0, 1}};
    const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands, image_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &black, 1, &whole);
    image_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kTransfer,
                      VK_ACCESS_2_TRANSFER_WRITE_BIT, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT);
}

void Sheet::put(VkCommandBuffer commands, const Image& picture, const Pane& pane)
{
    const auto least = [](std::uint32_t size, int room) {
        return std::min(size, static_cast<std::uint32_t>(std::max(room, 0)));
    };
    VkImageCopy copy{};
    copy.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    copy.dstSubresource = copy.srcSubresource;
    copy.dstOffset = {pane.x, pane.y, 0};
    copy.extent = {least(picture.extent().width, pane.sheetWidth - pane.x),
                   least(picture.extent().height, pane.sheetHeight - pane.y), 1};
    const VkRect2D place{{pane.x, pane.y}, {copy.extent.width, copy.extent.height}};
    const bool anew = places_.empty() || isElsewhere(place);
    image_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kTransfer,
                      VK_ACCESS_2_TRANSFER_READ_BIT, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, anew);
    if (anew) {
        places_.clear();
        clear(commands);
    }
    if (!holds(place))
        places_.push_back(place);
    if (pane.x >= 0 && pane.y >= 0 && copy.extent.width > 0 && copy.extent.height > 0)
        vkCmdCopyImage(commands, picture.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image_.get(),
                       VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    image_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kTransfer,
                      VK_ACCESS_2_TRANSFER_WRITE_BIT, kTransfer, VK_ACCESS_2_TRANSFER_READ_BIT);
}

}  // namespace knotspan
