// The logical device that everything is drawn with, its one queue, and what it can and cannot do.
#pragma once

#include <atomic>
#include <functional>
#include <optional>

#include "renderer/vulkan/instance.h"

namespace knotspan {

// What the paths ask of a device. An empty reason means that it can.
struct DeviceAbilities {
    std::string noMeshStages;
    std::string noTessellation;
    std::string noGeometry;
    std::string noDouble;  // for the compute stage
    std::uint32_t maxTessellationLevel = 64;
    std::uint32_t meshVertices = 64;  // of a mesh group, as the device likes them
    std::uint32_t meshTriangles = 98;
    // Mesa's software driver draws wrongly above 65,535 tessellated vertices a draw; 0: no such limit.
    std::uint32_t tessellatedVerticesPerDraw = 0;
    bool swapchain = false;
};

class Device {
public:
    // `index` counts Instance::devices(); nothing: a discrete card before an integrated one before software.
    Device(const Instance& instance, std::optional<int> index);
    ~Device();
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] VkDevice get() const { return device_; }
    [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
    [[nodiscard]] VkQueue queue() const { return queue_; }
    [[nodiscard]] std::uint32_t queueFamily() const { return queueFamily_; }
    [[nodiscard]] std::uint32_t timestampBits() const;  // 0: the queue has no clock
    [[nodiscard]] const VkPhysicalDeviceLimits& limits() const { return properties_.limits; }
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const std::string& driver() const { return driver_; }  // its name and version
    [[nodiscard]] std::uint32_t vulkanVersion() const { return properties_.apiVersion; }
    [[nodiscard]] const DeviceAbilities& abilities() const { return abilities_; }
    [[nodiscard]] PFN_vkCmdDrawMeshTasksEXT drawMeshTasks() const { return drawMeshTasks_; }
    [[nodiscard]] PFN_vkCmdDrawMeshTasksIndirectEXT drawMeshTasksIndirect() const
    {
        return drawMeshTasksIndirect_;
    }

    // The memory type that has all `required` properties, and `preferred` ones where one of those has them.
    [[nodiscard]] std::uint32_t memoryType(std::uint32_t allowed, VkMemoryPropertyFlags required,
                                           VkMemoryPropertyFlags preferred) const;

    // Bytes of buffers and images that live now.
    mutable std::atomic<std::uint64_t> allocatedBytes = 0;

    // Records commands, submits them and waits until they are done.
    void execute(const std::function<void(VkCommandBuffer)>& record, VkSemaphore wait = VK_NULL_HANDLE,
                 VkSemaphore signal = VK_NULL_HANDLE) const;

private:
    Device() = default;
    void findAbilities();
    void createLogicalDevice();

    VkPhysicalDevice physical_ = VK_NULL_HANDLE;
    VkPhysicalDeviceProperties properties_{};
    VkPhysicalDeviceMemoryProperties memory_{};
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueue queue_ = VK_NULL_HANDLE;
    std::uint32_t queueFamily_ = 0;
    std::string name_;
    std::string driver_;
    DeviceAbilities abilities_;
    PFN_vkCmdDrawMeshTasksEXT drawMeshTasks_ = nullptr;
    PFN_vkCmdDrawMeshTasksIndirectEXT drawMeshTasksIndirect_ = nullptr;
    CommandPool commandPool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    Fence done_;
};

// A full barrier between `before` and `after` for memory; for images see Image::transition.
void memoryBarrier(VkCommandBuffer commands, VkPipelineStageFlags2 before, VkAccessFlags2 written,
                   VkPipelineStageFlags2 after, VkAccessFlags2 read);

}  // namespace knotspan
