// A buffer with memory of its own, and the uploader through which all bytes reach the device.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "renderer/vulkan/device.h"

namespace knotspan {

class Buffer {
public:
    enum class Place { device, upload, readBack };

    Buffer() = default;
    // Device buffers are storage, indirect and transfer buffers at once. `bytes` above 0.
    Buffer(const Device& device, VkDeviceSize bytes, Place place);
    Buffer(Buffer&& other) noexcept;
    Buffer& operator=(Buffer&& other) noexcept;
    ~Buffer();

    [[nodiscard]] VkBuffer get() const { return buffer_; }
    [[nodiscard]] VkDeviceSize bytes() const { return bytes_; }
    [[nodiscard]] std::byte* mapped() const { return mapped_; }  // null for Place::device

private:
    const Device* device_ = nullptr;
    VkBuffer buffer_ = VK_NULL_HANDLE;
    VkDeviceMemory memory_ = VK_NULL_HANDLE;
    VkDeviceSize bytes_ = 0;
    VkDeviceSize allocated_ = 0;
    std::byte* mapped_ = nullptr;
};

// Gathers writes to device buffers and copies them at the start of the next frame.
class Uploader {
public:
    explicit Uploader(const Device& device) : device_(device) {}

    void write(const Buffer& target, VkDeviceSize offset, std::span<const std::byte> bytes);
    template <class T>
    void write(const Buffer& target, VkDeviceSize firstElement, std::span<const T> elements)
    {
        write(target, firstElement * sizeof(T), std::as_bytes(elements));
    }

    // Records the copies and a barrier after them. The command buffer must be done before the next flush.
    // Returns the bytes that travel.
    VkDeviceSize flush(VkCommandBuffer commands);

    // Forgets writes to a buffer that is about to go.
    void discard() { copies_.clear(), pending_.clear(); }

private:
    struct Copy {
        VkBuffer target;
        VkBufferCopy region;
    };

    const Device& device_;
    Buffer staging_;
    std::vector<std::byte> pending_;
    std::vector<Copy> copies_;
};

}  // namespace knotspan
