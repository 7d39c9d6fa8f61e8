#include "renderer/vulkan/image.h"

namespace knotspan {

Image::Image(const Device& device, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
             VkImageAspectFlags aspect)
    : extent_(extent),
      aspect_(aspect)
{
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage;
    VkImage image = VK_NULL_HANDLE;
    vkCheck(vkCreateImage(device.get(), &info, nullptr, &image), "making an image");
    image_ = {device.get(), image};

    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(device.get(), image, &requirements);
    memory_ = {device, requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
    vkCheck(vkBindImageMemory(device.get(), image, memory_.get(), 0), "reserving memory for an image");

    VkImageViewCreateInfo viewInfo{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    viewInfo.image = image;
    viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
    viewInfo.format = format;
    viewInfo.subresourceRange = {aspect, 0, 1, 0, 1};
    VkImageView view = VK_NULL_HANDLE;
    vkCheck(vkCreateImageView(device.get(), &viewInfo, nullptr, &view), "making an image");
    view_ = {device.get(), view};
}

void Image::transition(VkCommandBuffer commands, VkImageLayout layout, VkPipelineStageFlags2 before,
                       VkAccessFlags2 written, VkPipelineStageFlags2 after, VkAccessFlags2 access, bool fresh)
{
    imageBarrier(commands, image_.get(), aspect_, fresh ? VK_IMAGE_LAYOUT_UNDEFINED : layout_, layout, before,
                 written, after, access);
    layout_ = layout;
}

void imageBarrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, VkImageLayout from,
                  VkImageLayout to, VkPipelineStageFlags2 before, VkAccessFlags2 written,
                  VkPipelineStageFlags2 after, VkAccessFlags2 access)
{
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = before;
    barrier.srcAccessMask = written;
    barrier.dstStageMask = after;
    barrier.dstAccessMask = access;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect, 0, 1, 0, 1};
    VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace knotspan
