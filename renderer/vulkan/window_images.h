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
    const Device& device_;
    VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
    VkExtent2D extent_{};
    std::vector<VkImage> images_;
    Semaphore acquired_;
    std::vector<Semaphore> drawn_;  // one an image: the presentation engine may still hold another's
};

}  // namespace knotspan
