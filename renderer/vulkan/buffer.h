// A buffer with memory of its own, and the uploader through which all bytes reach the device.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "renderer/vulkan/device_memory.h"

namespace knotspan {

class Buffer {
public:
    enum class Place { device, upload, readBack };

    Buffer() = default;
    // Device buffers are storage, indirect and transfer buffers at once. `bytes` above 0.
    Buffer(const Device& device, VkDeviceSize bytes, Place place);

    [[nodiscard]] VkBuffer get() const { return buffer_.get(); }
    [[nodiscard]] VkDeviceSize bytes() const { return bytes_; }
    [[nodiscard]] std::byte* mapped() const { return mapped_; }  // null for Place::device

private:
    DeviceMemory memory_;  // outlives the buffer in it
    DeviceHandle<VkBuffer, vkDestroyBuffer> buffer_;
    VkDeviceSize bytes_ = 0;
    std::byte* mapped_ = nullptr;
};

// Gathers writes to device buffers and copies them at the start of the next frame.
class Uploader {
public:
    explicit Uploader(const Device& device) : device_(device) {}

    // Later writes win over earlier ones to the same bytes.
    void write(const Buffer& target, VkDeviceSize offset, std::span<const std::byte> bytes);
    template <class T>
    void write(const Buffer& target, VkDeviceSize firstElement, std::span<const T> elements)
    {
        write(target, firstElement * sizeof(T), std::as_bytes(elements));
    }

    // Room for elements that the caller writes before the next call.
    [[nodiscard]] std::span<std::byte> room(const Buffer& target, VkDeviceSize offset, size_t bytes);
    template <class T>
    [[nodiscard]] std::span<T> room(const Buffer& target, VkDeviceSize firstElement, size_t count)
    {
        static_assert(alignof(T) <= 4, "all that is uploaded comes in words");
        return {reinterpret_cast<T*>(room(target, firstElement * sizeof(T), count * sizeof(T)).data()),
                count};
    }

    // Forgets the writes to a buffer whose whole content is about to be written, or that is about to go.
    void forget(const Buffer& target);
    void forgetAll();

    // Records the copies and a barrier after them. Returns the bytes that travel.
    [[nodiscard]] VkDeviceSize record(VkCommandBuffer commands);
    // Those commands are done: what they sent is forgotten, and room beyond the ordinary given back.
    void sent();

private:
    struct Copy {
        VkBuffer target;
        VkBufferCopy region;
        bool overlapsEarlier;
    };

    const Device& device_;
    Buffer staging_;
    std::vector<std::byte> pending_;
    std::vector<Copy> copies_;
};

}  // namespace knotspan
