// The Vulkan instance, with the validation layer where it is wanted and what the layer said.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "renderer/vulkan/vulkan.h"

namespace knotspan {

enum class Validation { off, whereInstalled, required };

class Instance {
public:
    // Switches on all surface extensions that the loader knows, so that a window can be served later.
    explicit Instance(Validation validation);
    ~Instance();
    Instance(const Instance&) = delete;
    Instance& operator=(const Instance&) = delete;

    [[nodiscard]] VkInstance get() const { return instance_; }

    [[nodiscard]] std::vector<std::string> messages() const;

    // The physical devices that speak Vulkan 1.3, in the loader's order.
    [[nodiscard]] std::vector<VkPhysicalDevice> devices() const;

private:
    static VkBool32 VKAPI_PTR receive(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                      VkDebugUtilsMessageTypeFlagsEXT types,
                                      const VkDebugUtilsMessengerCallbackDataEXT* data, void* self);

    VkInstance instance_ = VK_NULL_HANDLE;
    VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;

    mutable std::mutex mutex_;
    std::vector<std::string> messages_;
};

// The sentence for a machine without a usable device.
[[nodiscard]] Error noDeviceError();

}  // namespace knotspan
