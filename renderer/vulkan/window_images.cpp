#include "renderer/vulkan/window_images.h"

#include <algorithm>

namespace knotspan {

namespace {

// Eight bits without a second sRGB encoding: the picture is encoded already.
VkSurfaceFormatKHR chooseFormat(const Device& device, VkSurfaceKHR surface)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, nullptr);
    std::vector<VkSurfaceFormatKHR> formats(count);
    vkCheck(vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, formats.data()),
            "asking what the window can show");
    for (const VkSurfaceFormatKHR& format : formats)
        if ((format.format == VK_FORMAT_B8G8R8A8_UNORM || format.format == VK_FORMAT_R8G8B8A8_UNORM) &&
            format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR)
            return format;
    throw VulkanError({"The window shows no 8-bit colours", {}, "Start Knotspan on another screen"});
}

// A new picture replaces one that waits, where the window system can; else the window system sets the pace.
VkPresentModeKHR choosePresentMode(const Device& device, VkSurfaceKHR surface)
{
    std::uint32_t count = 0;
    vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, nullptr);
    std::vector<VkPresentModeKHR> modes(count);
    vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, modes.data());
    const bool mailbox = std::find(modes.begin(), modes.end(), VK_PRESENT_MODE_MAILBOX_KHR) != modes.end();
    return mailbox ? VK_PRESENT_MODE_MAILBOX_KHR : VK_PRESENT_MODE_FIFO_KHR;
}

Semaphore makeSemaphore(const Device& device)
{
    const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    VkSemaphore semaphore = VK_NULL_HANDLE;
    vkCheck(vkCreateSemaphore(device.get(), &info, nullptr, &semaphore), "making a semaphore");
    return {device.get(), semaphore};
}

}  // namespace

WindowImages::WindowImages(const Device& device, VkSurfaceKHR surface, VkExtent2D wanted)
    : device_(device),
      acquired_(makeSemaphore(device))
{
    VkBool32 supported = VK_FALSE;
    if (device.abilities().swapchain)
        vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.queueFamily(), surface, &supported);
    if (supported == VK_FALSE)
        throw VulkanError({"This graphics device cannot draw into the window", {}, ""});
    VkSurfaceCapabilitiesKHR abilities;
    vkCheck(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device.physical(), surface, &abilities),
            "asking what the window can show");
    const VkExtent2D least = abilities.minImageExtent;
    const VkExtent2D most = abilities.maxImageExtent;
    extent_ = abilities.currentExtent.width != ~0U
                  ? abilities.currentExtent
                  : VkExtent2D{std::clamp(wanted.width, least.width, std::max(least.width, most.width)),
                               std::clamp(wanted.height, least.height, std::max(least.height, most.height))};
    if (extent_.width > 0 && extent_.height > 0)
        makeSwapchain(surface, abilities);
}

void WindowImages::makeSwapchain(VkSurfaceKHR surface, const VkSurfaceCapabilitiesKHR& abilities)
{
    const VkSurfaceFormatKHR format = chooseFormat(device_, surface);
    VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    info.surface = surface;
    info.minImageCount = abilities.minImageCount + 1;
    if (abilities.maxImageCount != 0)
        info.minImageCount = std::min(info.minImageCount, abilities.maxImageCount);
    info.imageFormat = format.format;
    info.imageColorSpace = format.colorSpace;
    info.imageExtent = extent_;
    info.imageArrayLayers = 1;
    info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    info.preTransform = abilities.currentTransform;
    info.compositeAlpha = (abilities.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0
                              ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                              : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    info.presentMode = choosePresentMode(device_, surface);
    info.clipped = VK_TRUE;
    VkSwapchainKHR swapchain = VK_NULL_HANDLE;
    vkCheck(vkCreateSwapchainKHR(device_.get(), &info, nullptr, &swapchain), "preparing the window");
    swapchain_ = {device_.get(), swapchain};
    std::uint32_t count = 0;
    vkGetSwapchainImagesKHR(device_.get(), swapchain, &count, nullptr);
    images_.resize(count);
    vkGetSwapchainImagesKHR(device_.get(), swapchain, &count, images_.data());
    for (std::uint32_t image = 0; image < count; ++image)
        drawn_.push_back(makeSemaphore(device_));
}

WindowImages::~WindowImages()
{
    vkDeviceWaitIdle(device_.get());
}

bool WindowImages::show(Image& picture)
{
    if (swapchain_.get() == VK_NULL_HANDLE)
        return false;
    constexpr std::uint64_t kPatienceNs = 250'000'000;  // a covered window may never take another picture
    std::uint32_t index = 0;
    const VkResult acquired = vkAcquireNextImageKHR(device_.get(), swapchain_.get(), kPatienceNs,
                                                    acquired_.get(), VK_NULL_HANDLE, &index);
    if (acquired == VK_ERROR_OUT_OF_DATE_KHR || acquired == VK_ERROR_SURFACE_LOST_KHR)
        return false;
    if (acquired == VK_TIMEOUT || acquired == VK_NOT_READY)
        return true;
    vkCheck(acquired, "waiting for the window");

    device_.execute([&](VkCommandBuffer commands) { copyFrom(picture, commands, images_[index]); },
                    acquired_.get(), drawn_[index].get());

    const VkSemaphore drawn = drawn_[index].get();
    const VkSwapchainKHR swapchain = swapchain_.get();
    VkPresentInfoKHR present{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    present.waitSemaphoreCount = 1;
    present.pWaitSemaphores = &drawn;
    present.swapchainCount = 1;
    present.pSwapchains = &swapchain;
    present.pImageIndices = &index;
    const VkResult presented = vkQueuePresentKHR(device_.queue(), &present);
    if (presented == VK_ERROR_OUT_OF_DATE_KHR || presented == VK_ERROR_SURFACE_LOST_KHR)
        return false;
    vkCheck(presented, "showing a picture");
    return presented != VK_SUBOPTIMAL_KHR && acquired != VK_SUBOPTIMAL_KHR;
}

void WindowImages::copyFrom(Image& picture, VkCommandBuffer commands, VkImage target) const
{
    imageBarrier(commands, target, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_UNDEFINED,
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0,
                 VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    const auto corner = [](VkExtent2D extent) {
        return VkOffset3D{static_cast<int>(extent.width), static_cast<int>(extent.height), 1};
    };
    VkImageBlit blit{};
    blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    blit.dstSubresource = blit.srcSubresource;
    blit.srcOffsets[1] = corner(picture.extent());
    blit.dstOffsets[1] = corner(extent_);
    vkCmdBlitImage(commands, picture.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target,
                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    imageBarrier(commands, target, VK_IMAGE_ASPECT_COLOR_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                 VK_IMAGE_LAYOUT_PRESENT_SRC_KHR, VK_PIPELINE_STAGE_2_BLIT_BIT,
                 VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0);
}

}  // namespace knotspan
