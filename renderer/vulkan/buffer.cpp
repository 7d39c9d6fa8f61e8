#include "renderer/vulkan/buffer.h"

#include <algorithm>
#include <cstring>

#include "model/core/check.h"

namespace knotspan {

namespace {

constexpr VkDeviceSize kOrdinaryFrame = 1 << 16;  // bytes of staging to begin with
constexpr VkDeviceSize kMostKept = 1 << 24;       // what a large model needed is given back

}  // namespace

Buffer::Buffer(const Device& device, VkDeviceSize bytes, Place place) : bytes_(bytes)
{
    VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    if (place == Place::device)
        info.usage |= VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT |
                      VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
    VkBuffer buffer = VK_NULL_HANDLE;
    vkCheck(vkCreateBuffer(device.get(), &info, nullptr, &buffer), "making a buffer");
    buffer_ = {device.get(), buffer};

    VkMemoryRequirements requirements;
    vkGetBufferMemoryRequirements(device.get(), buffer, &requirements);
    constexpr VkMemoryPropertyFlags kHost =
        VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    switch (place) {
    case Place::device:
        memory_ = {device, requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
        break;
    case Place::upload:
        memory_ = {device, requirements, kHost, 0};
        break;
    case Place::readBack:
        memory_ = {device, requirements, kHost, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
        break;
    }
    vkCheck(vkBindBufferMemory(device.get(), buffer, memory_.get(), 0), "reserving memory");
    if (place != Place::device) {
        void* mapped = nullptr;
        vkCheck(vkMapMemory(device.get(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped), "reserving memory");
        mapped_ = static_cast<std::byte*>(mapped);
    }
}

void Uploader::write(const Buffer& target, VkDeviceSize offset, std::span<const std::byte> bytes)
{
    if (!bytes.empty())
        std::memcpy(room(target, offset, bytes.size()).data(), bytes.data(), bytes.size());
}

std::span<std::byte> Uploader::room(const Buffer& target, VkDeviceSize offset, size_t bytes)
{
    check(bytes > 0 && offset + bytes <= target.bytes(), "an upload lies inside its buffer");
    const bool overlaps = std::any_of(copies_.begin(), copies_.end(), [&](const Copy& earlier) {
        return earlier.target == target.get() && earlier.region.dstOffset < offset + bytes &&
               offset < earlier.region.dstOffset + earlier.region.size;
    });
    const size_t start = pending_.size();
    copies_.push_back({target.get(), {start, offset, bytes}, overlaps});
    pending_.resize(start + bytes);
    return std::span(pending_).subspan(start);
}

void Uploader::forget(const Buffer& target)
{
    std::erase_if(copies_, [&](const Copy& copy) { return copy.target == target.get(); });
    if (copies_.empty())
        pending_.clear();
}

void Uploader::forgetAll()
{
    copies_.clear();
    pending_.clear();
}

VkDeviceSize Uploader::record(VkCommandBuffer commands)
{
    if (copies_.empty())
        return 0;
    if (staging_.bytes() < pending_.size()) {
        staging_ = {};  // first, so that both never live at once
        staging_ =
            Buffer(device_, std::max<VkDeviceSize>(pending_.size(), kOrdinaryFrame), Buffer::Place::upload);
    }
    std::memcpy(staging_.mapped(), pending_.data(), pending_.size());
    VkDeviceSize bytes = 0;
    for (const Copy& copy : copies_) {
        if (copy.overlapsEarlier)
            memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                          VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
        vkCmdCopyBuffer(commands, staging_.get(), copy.target, 1, &copy.region);
        bytes += copy.region.size;
    }
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_INDEX_READ_BIT |
                      VK_ACCESS_2_TRANSFER_WRITE_BIT);
    return bytes;
}

void Uploader::sent()
{
    forgetAll();
    if (pending_.capacity() > kMostKept)
        pending_.shrink_to_fit();
    if (staging_.bytes() > kMostKept)
        staging_ = {};
}

}  // namespace knotspan
