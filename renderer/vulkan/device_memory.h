// Memory of the device that one buffer or image lives in; counted in Device::allocatedBytes while it does.
#pragma once

#include "renderer/vulkan/device.h"

namespace knotspan {

class DeviceMemory {
public:
    DeviceMemory() = default;
    // Of a type that has all `required` properties, and the `preferred` ones where there is such.
    DeviceMemory(const Device& device, const VkMemoryRequirements& requirements,
                 VkMemoryPropertyFlags required, VkMemoryPropertyFlags preferred);
    DeviceMemory(DeviceMemory&& other) noexcept;
    DeviceMemory& operator=(DeviceMemory&& other) noexcept;
    ~DeviceMemory();

    [[nodiscard]] VkDeviceMemory get() const { return memory_.get(); }

private:
    const Device* device_ = nullptr;
    VkDeviceSize bytes_ = 0;
    DeviceHandle<VkDeviceMemory, vkFreeMemory> memory_;
};

}  // namespace knotspan
