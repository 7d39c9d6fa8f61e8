// A Vulkan swapchain and the copying of a finished picture into it.
#pragma once

#include "renderer/vulkan/image.h"

namespace knotspan {

class WindowImages {
public:
    WindowImages(const Device& device, VkSurfaceKHR surface, VkExtent2D wanted);
    ~WindowImages();
    WindowImages(const WindowImages&) = delete;
    WindowImages& operator=(const WindowImages&) = delete;

    // Shows `picture`, scaled where the sizes differ. False: the window has changed and wants another
    // swapchain.
    [[nodiscard]] bool show(Image& picture);

private:
    void makeSwapchain(VkSurfaceKHR surface, const VkSurfaceCapabilitiesKHR& abilities);
    void copyFrom(Image& picture, VkCommandBuffer commands, VkImage target) const;

    const Device& device_;
    DeviceHandle<VkSwapchainKHR, vkDestroySwapchainKHR> swapchain_;
    VkExtent2D extent_{};
    std::vector<VkImage> images_;
    Semaphore acquired_;
    std::vector<Semaphore> drawn_;  // one an image: the presentation engine may still hold another's
};

}  // namespace knotspan
