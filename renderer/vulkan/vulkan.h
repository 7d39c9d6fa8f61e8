// Vulkan as this folder and its users include it, and the one exception of the renderer: thrown where a
// Vulkan call fails, caught at the renderer's border, where it becomes an Error.
#pragma once

#include <exception>
#include <string>
#include <utility>

#include <vulkan/vulkan.h>

#include "model/core/result.h"

namespace knotspan {

class VulkanError : public std::exception {
public:
    explicit VulkanError(Error error, VkResult result = VK_ERROR_UNKNOWN)
        : error_(std::move(error)),
          result_(result),
          text_(error_.sentence())
    {
    }

    [[nodiscard]] const Error& error() const { return error_; }
    [[nodiscard]] bool deviceLost() const { return result_ == VK_ERROR_DEVICE_LOST; }
    [[nodiscard]] const char* what() const noexcept override { return text_.c_str(); }

private:
    Error error_;
    VkResult result_;
    std::string text_;
};

// `doing` completes "The graphics device failed while ...".
void vkCheck(VkResult result, const char* doing);

// Owns a handle that a device made: DeviceHandle<VkSampler, vkDestroySampler>.
template <class Handle, auto destroy>
class DeviceHandle {
public:
    DeviceHandle() = default;
    DeviceHandle(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
    DeviceHandle(DeviceHandle&& other) noexcept
        : device_(other.device_),
          handle_(std::exchange(other.handle_, VK_NULL_HANDLE))
    {
    }
    DeviceHandle& operator=(DeviceHandle&& other) noexcept
    {
        std::swap(device_, other.device_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~DeviceHandle()
    {
        if (handle_ != VK_NULL_HANDLE)
            destroy(device_, handle_, nullptr);
    }

    [[nodiscard]] Handle get() const { return handle_; }

private:
    VkDevice device_ = VK_NULL_HANDLE;
    Handle handle_ = VK_NULL_HANDLE;
};

using DescriptorPool = DeviceHandle<VkDescriptorPool, vkDestroyDescriptorPool>;
using DescriptorSetLayout = DeviceHandle<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using PipelineLayout = DeviceHandle<VkPipelineLayout, vkDestroyPipelineLayout>;
using Pipeline = DeviceHandle<VkPipeline, vkDestroyPipeline>;
using ShaderModule = DeviceHandle<VkShaderModule, vkDestroyShaderModule>;
using CommandPool = DeviceHandle<VkCommandPool, vkDestroyCommandPool>;
using Fence = DeviceHandle<VkFence, vkDestroyFence>;
using Semaphore = DeviceHandle<VkSemaphore, vkDestroySemaphore>;
using QueryPool = DeviceHandle<VkQueryPool, vkDestroyQueryPool>;
using ImageView = DeviceHandle<VkImageView, vkDestroyImageView>;

}  // namespace knotspan
