#include "renderer/vulkan/device_memory.h"

#include <utility>

namespace knotspan {

DeviceMemory::DeviceMemory(const Device& device, const VkMemoryRequirements& requirements,
                           VkMemoryPropertyFlags required, VkMemoryPropertyFlags preferred)
{
    VkMemoryAllocateInfo allocate{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    allocate.allocationSize = requirements.size;
    allocate.memoryTypeIndex = device.memoryType(requirements.memoryTypeBits, required, preferred);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    vkCheck(vkAllocateMemory(device.get(), &allocate, nullptr, &memory), "reserving memory");
    memory_ = {device.get(), memory};
    device_ = &device;
    bytes_ = requirements.size;
    device.allocatedBytes += bytes_;
}

DeviceMemory::DeviceMemory(DeviceMemory&& other) noexcept
{
    *this = std::move(other);
}

DeviceMemory& DeviceMemory::operator=(DeviceMemory&& other) noexcept
{
    std::swap(device_, other.device_);
    std::swap(bytes_, other.bytes_);
    std::swap(memory_, other.memory_);
    return *this;
}

DeviceMemory::~DeviceMemory()
{
    if (device_ != nullptr)
        device_->allocatedBytes -= bytes_;
}

}  // namespace knotspan
