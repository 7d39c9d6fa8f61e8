#include "renderer/frame_targets.h"

#include <cstring>

#include "renderer/vulkan/pipeline.h"

namespace knotspan {

namespace {

constexpr VkPipelineStageFlags2 kDepthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

VkRenderingAttachmentInfo attachment(const Image& image, VkImageLayout layout, VkClearValue clear, bool fresh)
{
    VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
    info.imageView = image.view();
    info.imageLayout = layout;
    info.loadOp = fresh ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    info.clearValue = clear;
    return info;
}

VkBufferImageCopy copyOf(VkImageAspectFlags aspect, VkRect2D part, VkDeviceSize offset)
{
    VkBufferImageCopy copy{};
    copy.bufferOffset = offset;
    copy.imageSubresource = {aspect, 0, 0, 1};
    copy.imageOffset = {part.offset.x, part.offset.y, 0};
    copy.imageExtent = {part.extent.width, part.extent.height, 1};
    return copy;
}

void copyPart(VkCommandBuffer commands, const Image& image, VkImageAspectFlags aspect, VkRect2D part,
              VkBuffer to, VkDeviceSize offset)
{
    const VkBufferImageCopy copy = copyOf(aspect, part, offset);
    vkCmdCopyImageToBuffer(commands, image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1, &copy);
}

void showToHost(VkCommandBuffer commands)
{
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

void copyOut(const Device& device, const Image& image, const Buffer& to)
{
    device.execute([&](VkCommandBuffer commands) {
        copyPart(commands, image, VK_IMAGE_ASPECT_COLOR_BIT, {{0, 0}, image.extent()}, to.get(), 0);
        showToHost(commands);
    });
}

}  // namespace

FrameTargets::FrameTargets(const Device& device, VkExtent2D extent)
    : device_(device),
      extent_(extent),
      colour_(device, kColourFormat, extent,
              VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                  VK_IMAGE_USAGE_TRANSFER_DST_BIT,
              VK_IMAGE_ASPECT_COLOR_BIT),
      indices_(device, kIndexFormat, extent,
               VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
               VK_IMAGE_ASPECT_COLOR_BIT),
      depth_(device, kDepthFormat, extent,
             VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
             VK_IMAGE_ASPECT_DEPTH_BIT),
      onePixel_(device, sizeof(Pixel), Buffer::Place::readBack)
{
}

void FrameTargets::begin(VkCommandBuffer commands)
{
    for (Image* image : {&colour_, &indices_})
        image->transition(
            commands, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0,
            VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
            VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT, true);
    depth_.transition(
        commands, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, 0,
        kDepthTests,
        VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT, true);
    start(commands, true);
}

void FrameTargets::start(VkCommandBuffer commands, bool fresh)
{
    VkClearValue background{};
    background.color = {{static_cast<float>(kBackground[0]) / 255.0F,
                         static_cast<float>(kBackground[1]) / 255.0F,
                         static_cast<float>(kBackground[2]) / 255.0F, 1.0F}};
    const VkClearValue nothing{};
    const VkRenderingAttachmentInfo colours[] = {
        attachment(colour_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, background, fresh),
        attachment(indices_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, nothing, fresh)};
    const VkRenderingAttachmentInfo depth =
        attachment(depth_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, nothing, fresh);
    VkRenderingInfo info{VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea = {{0, 0}, extent_};
    info.layerCount = 1;
    info.colorAttachmentCount = 2;
    info.pColorAttachments = colours;
    info.pDepthAttachment = &depth;
    vkCmdBeginRendering(commands, &info);
    const VkViewport viewport{0, 0, static_cast<float>(extent_.width), static_cast<float>(extent_.height),
                              0, 1};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &info.renderArea);
}

void FrameTargets::pause(VkCommandBuffer commands, Copied copied)
{
    copied_ = copied;
    vkCmdEndRendering(commands);
    transition(commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    // What is made next takes the place of what the drawing stages have read and counted.
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                  VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
}

// Of the images that are copied: into that layout, or back into the ones that are drawn into.
void FrameTargets::transition(VkCommandBuffer commands, VkImageLayout layout)
{
    constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_TRANSFER_BIT;
    constexpr VkAccessFlags2 kCopies = VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT;
    constexpr VkAccessFlags2 kDepth =
        VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    constexpr VkPipelineStageFlags2 kColours = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
    constexpr VkAccessFlags2 kColour =
        VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT;
    const bool isBack = layout == VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL;
    const auto move = [&](Image& image, VkImageLayout drawn, VkPipelineStageFlags2 stages,
                          VkAccessFlags2 access) {
        if (isBack)
            image.transition(commands, drawn, kTransfer, kCopies, stages, access);
        else
            image.transition(commands, layout, stages, access, kTransfer, kCopies);
    };
    move(depth_, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, kDepthTests, kDepth);
    if (copied_ == Copied::depths)
        return;
    for (Image* image : {&colour_, &indices_})
        move(*image, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, kColours, kColour);
}

void FrameTargets::copy(VkCommandBuffer commands, const Rows& rows)
{
    const VkRect2D part{{0, static_cast<std::int32_t>(rows.first)}, {extent_.width, rows.count}};
    copyPart(commands, depth_, VK_IMAGE_ASPECT_DEPTH_BIT, part, rows.to, rows.depths);
    if (copied_ == Copied::all) {
        copyPart(commands, colour_, VK_IMAGE_ASPECT_COLOR_BIT, part, rows.to, rows.colours);
        copyPart(commands, indices_, VK_IMAGE_ASPECT_COLOR_BIT, part, rows.to, rows.shown);
    }
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                  VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_2_ALL_GRAPHICS_BIT,
                  VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
}

void FrameTargets::put(VkCommandBuffer commands, VkBuffer colours, VkDeviceSize offset)
{
    constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_TRANSFER_BIT;
    colour_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kTransfer,
                       VK_ACCESS_2_TRANSFER_READ_BIT, kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT);
    const VkBufferImageCopy copy = copyOf(VK_IMAGE_ASPECT_COLOR_BIT, {{0, 0}, extent_}, offset);
    vkCmdCopyBufferToImage(commands, colours, colour_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
}

void FrameTargets::resume(VkCommandBuffer commands)
{
    transition(commands, VK_IMAGE_LAYOUT_ATTACHMENT_OPTIMAL);
    // What was drawn before the pause is drawn over.
    memoryBarrier(commands, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                  VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                  VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT);
    start(commands, false);
}

void FrameTargets::end(VkCommandBuffer commands)
{
    vkCmdEndRendering(commands);
    for (Image* image : {&colour_, &indices_})
        image->transition(commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                          VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                          VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT, VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
                          VK_ACCESS_2_TRANSFER_READ_BIT);
}

Picture readPicture(const Device& device, const Image& image)
{
    const VkExtent2D extent = image.extent();
    Picture picture{static_cast<int>(extent.width), static_cast<int>(extent.height), {}};
    picture.rgba.resize(size_t{4} * extent.width * extent.height);
    const Buffer readBack(device, picture.rgba.size(), Buffer::Place::readBack);
    copyOut(device, image, readBack);
    std::memcpy(picture.rgba.data(), readBack.mapped(), picture.rgba.size());
    return picture;
}

KsQuadIndices FrameTargets::readKsQuads() const
{
    KsQuadIndices ksquads{static_cast<int>(extent_.width), static_cast<int>(extent_.height), {}};
    ksquads.indices.resize(size_t{1} * extent_.width * extent_.height);
    constexpr size_t kBytes = 2 * sizeof(std::uint32_t);  // the index, and where in the KSQuad
    const Buffer readBack(device_, kBytes * ksquads.indices.size(), Buffer::Place::readBack);
    copyOut(device_, indices_, readBack);
    for (size_t k = 0; k < ksquads.indices.size(); ++k)
        std::memcpy(&ksquads.indices[k], readBack.mapped() + kBytes * k, sizeof(ksquads.indices[k]));
    return ksquads;
}

FrameTargets::Pixel FrameTargets::pixelAt(std::uint32_t x, std::uint32_t y)
{
    const VkRect2D place{{static_cast<int>(x), static_cast<int>(y)}, {1, 1}};
    device_.execute([&](VkCommandBuffer commands) {
        // It stays so until the next frame, which starts it afresh.
        depth_.transition(commands, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, kDepthTests,
                          VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT, VK_PIPELINE_STAGE_2_TRANSFER_BIT,
                          VK_ACCESS_2_TRANSFER_READ_BIT);
        copyPart(commands, indices_, VK_IMAGE_ASPECT_COLOR_BIT, place, onePixel_.get(),
                 offsetof(Pixel, ksquad));
        copyPart(commands, depth_, VK_IMAGE_ASPECT_DEPTH_BIT, place, onePixel_.get(), offsetof(Pixel, depth));
        showToHost(commands);
    });
    Pixel pixel;
    std::memcpy(&pixel, onePixel_.mapped(), sizeof(pixel));
    return pixel;
}

}  // namespace knotspan
