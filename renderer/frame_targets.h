// The images that a frame is drawn into: colour, the KSQuads' indices for picking, and depth.
#pragma once

#include "renderer/renderer.h"
#include "renderer/vulkan/buffer.h"
#include "renderer/vulkan/image.h"

namespace knotspan {

class FrameTargets {
public:
    FrameTargets(const Device& device, VkExtent2D extent);

    [[nodiscard]] VkExtent2D extent() const { return extent_; }
    [[nodiscard]] Image& colour() { return colour_; }

    // Between the two, drawing goes into these images, which start as the background. After end() they can be
    // copied.
    void begin(VkCommandBuffer commands);
    void end(VkCommandBuffer commands);
    // Between begin() and end(): nothing is drawn until resume(), and what was so far can be copied.
    enum class Copied { depths, all };
    void pause(VkCommandBuffer commands, Copied copied);
    // Some rows, and where in a buffer each pixel's depth goes, four bytes; with Copied::all its colour, four
    // bytes, and what it shows, eight (pixel_place.glsl), too. All stages may read them.
    struct Rows {
        std::uint32_t first;
        std::uint32_t count;
        VkBuffer to;
        VkDeviceSize depths;
        VkDeviceSize colours;
        VkDeviceSize shown;
    };
    void copy(VkCommandBuffer commands, const Rows& rows);
    // With Copied::all, after the last copy: other colours for the whole picture.
    void put(VkCommandBuffer commands, VkBuffer colours, VkDeviceSize offset);
    void resume(VkCommandBuffer commands);

    [[nodiscard]] KsQuadIndices readKsQuads() const;
    struct Pixel {
        std::uint32_t ksquad = 0;  // the index + 1; 0: the background
        std::uint32_t place = 0;   // in it (pixel_place.glsl)
        float depth = 0;           // of the middle of the pixel, as the projection gives it
    };
    [[nodiscard]] Pixel pixelAt(std::uint32_t x, std::uint32_t y);

private:
    void start(VkCommandBuffer commands, bool fresh);
    void transition(VkCommandBuffer commands, VkImageLayout layout);

    const Device& device_;
    VkExtent2D extent_;
    Image colour_;
    Image indices_;
    Image depth_;
    Buffer onePixel_;
    Copied copied_ = Copied::depths;
};

// Of an image that can be copied, four bytes a pixel.
[[nodiscard]] Picture readPicture(const Device& device, const Image& image);

}  // namespace knotspan
