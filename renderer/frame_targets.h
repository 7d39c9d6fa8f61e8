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
    // Between begin() and end(): nothing is drawn until resume(), and buffers get each pixel's depth so far,
    // and where one is named its colour and what it shows (eight bytes, pixel_place.glsl). All stages may
    // read them.
    struct Copies {
        VkBuffer depths;
        VkDeviceSize depthsFrom = 0;
        VkBuffer pixels = VK_NULL_HANDLE;
        VkDeviceSize shownFrom = 0;
    };
    void pause(VkCommandBuffer commands, const Copies& copies);
    void resume(VkCommandBuffer commands);
    // While paused: other colours, as pause() copies them.
    void put(VkCommandBuffer commands, VkBuffer colours);

    [[nodiscard]] KsQuadIndices readKsQuads() const;
    struct Pixel {
        std::uint32_t ksquad = 0;  // the index + 1; 0: the background
        std::uint32_t place = 0;   // in it (pixel_place.glsl)
        float depth = 0;           // of the middle of the pixel, as the projection gives it
    };
    [[nodiscard]] Pixel pixelAt(std::uint32_t x, std::uint32_t y);

private:
    void start(VkCommandBuffer commands, bool fresh);

    const Device& device_;
    VkExtent2D extent_;
    Image colour_;
    Image indices_;
    Image depth_;
    Buffer onePixel_;
};

// Of an image that can be copied, four bytes a pixel.
[[nodiscard]] Picture readPicture(const Device& device, const Image& image);

}  // namespace knotspan
