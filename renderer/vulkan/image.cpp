#include "renderer/vulkan/image.h"

#include <utility>

namespace knotspan {

// Through the empty image, so that the destructor cleans up where something here fails.
Image::Image(const Device& device, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage,
             VkImageAspectFlags aspect)
    : Image()
{
    device_ = &device;
    extent_ = extent;
    aspect_ = aspect;
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage;
    vkCheck(vkCreateImage(device.get(), &info, nullptr, &image_), "making an image");

    VkMemoryRequirements requirements;
    vkGetImageMemoryRequirements(device.get(), image_, &requirements);
    VkMemoryAllocateInfo allocate{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    allocate.allocationSize = requirements.size;
    allocate.memoryTypeIndex =
        device.memoryType(requirements.memoryTypeBits, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    vkCheck(vkAllocateMemory(device.get(), &allocate, nullptr, &memory_), "reserving memory for an image");
    allocated_ = requirements.size;
    device.allocatedBytes += allocated_;
    vkCheck(vkBindImageMemory(device.get(), image_, memory_, 0), "reserving memory for an image");

    VkImageViewCreateInfo viewInfo{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    viewInfo.image = image_;
    viewInfo.viewType = VK_IMAGE_VIEW_TYPE_2D;
    viewInfo.format = format;
    viewInfo.subresourceRange = {aspect, 0, 1, 0, 1};
    VkImageView view = VK_NULL_HANDLE;
    vkCheck(vkCreateImageView(device.get(), &viewInfo, nullptr, &view), "making an image");
    view_ = {device.get(), view};
}

Image::Image(Image&& other) noexcept
{
    *this = std::move(other);
}

Image& Image::operator=(Image&& other) noexcept
{
    std::swap(device_, other.device_);
    std::swap(image_, other.image_);
    std::swap(memory_, other.memory_);
    std::swap(allocated_, other.allocated_);
    std::swap(extent_, other.extent_);
    std::swap(aspect_, other.aspect_);
    std::swap(layout_, other.layout_);
    std::swap(view_, other.view_);
    return *this;
}

Image::~Image()
{
    if (device_ == nullptr)
        return;
    view_ = {};
    vkDestroyImage(device_->get(), image_, nullptr);
    vkFreeMemory(device_->get(), memory_, nullptr);
    device_->allocatedBytes -= allocated_;
}

void Image::transition(VkCommandBuffer commands, VkImageLayout layout, VkPipelineStageFlags2 before,
                       VkAccessFlags2 written, VkPipelineStageFlags2 after, VkAccessFlags2 access, bool fresh)
{
    imageBarrier(commands, image_, aspect_, fresh ? VK_IMAGE_LAYOUT_UNDEFINED : layout_, layout, before,
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
