#include "renderer/vulkan/vulkan.h"

namespace knotspan {

namespace {

Error describe(VkResult result, const std::string& doing)
{
    switch (result) {
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
        return {"The graphics device has no memory left while " + doing,
                {},
                "Close other programs, or open a smaller model"};
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return {"The memory is full while " + doing, {}, "Close other programs, or open a smaller model"};
    case VK_ERROR_DEVICE_LOST:
        return {"The graphics device stopped answering while " + doing,
                {},
                "Save your work and start Knotspan again; if it happens again, update the graphics driver"};
    default:
        return {"The graphics device failed while " + doing + " (Vulkan result " +
                    std::to_string(static_cast<int>(result)) + ")",
                {},
                "Update the graphics driver, or choose another device with --device"};
    }
}

}  // namespace

void vkCheck(VkResult result, const char* doing)
{
    if (result < 0)
        throw VulkanError(describe(result, doing), result);
}

}  // namespace knotspan
