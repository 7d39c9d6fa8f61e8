// One renderer for all tests of a program, because opening a device takes its time; and comparisons of
// pictures.
#pragma once

#include <gtest/gtest.h>

#include "renderer/renderer.h"

namespace knotspan::testing {

// The shared renderer, with the validation layer where it is installed; null where this machine has no Vulkan
// device.
[[nodiscard]] Renderer* sharedRenderer();

// A frame that shows the whole scene.
[[nodiscard]] Frame frameOf(const Scene& scene, PathId path, int width = 320, int height = 240,
                            std::string_view view = "iso");

// Syncs, draws and reads back; fails the test where one of them does.
struct Drawn {
    Picture picture;
    FrameStats stats;
};
[[nodiscard]] Drawn drawn(Renderer& renderer, const Scene& scene, const Frame& frame);

[[nodiscard]] bool isBackground(const Picture& picture, int x, int y);
[[nodiscard]] size_t shownPixels(const Picture& picture);  // that are not background

// Colours of pixels: 0xRRGGBB.
[[nodiscard]] std::uint32_t colourAt(const Picture& picture, int x, int y);
// How many pixels have it, to the rounding of 8 bits.
[[nodiscard]] size_t pixelsOf(const Picture& picture, std::uint32_t colour);
// Whether one within two pixels has it.
[[nodiscard]] bool isNear(const Picture& picture, const Vec2& at, std::uint32_t colour);
// How many pixels differ between pictures of one size.
[[nodiscard]] size_t changedPixels(const Picture& a, const Picture& b);

struct Difference {
    size_t silhouetteOff =
        0;  // pixels shown in one picture and further than a pixel from any shown in the other
    double meanShaded = 0;  // mean of the channels' differences over pixels shown in both, 0 .. 255
};
[[nodiscard]] Difference compare(const Picture& a, const Picture& b);

// Tests of every path, and what each is called: "mesh9x9".
[[nodiscard]] std::vector<PathId> allPaths();
[[nodiscard]] std::string pathTestName(const ::testing::TestParamInfo<PathId>& test);

}  // namespace knotspan::testing

#define KNOTSPAN_NEED_RENDERER(renderer)                                          \
    ::knotspan::Renderer* const renderer = ::knotspan::testing::sharedRenderer(); \
    if (renderer == nullptr)                                                      \
    GTEST_SKIP() << "no Vulkan device here"

#define KNOTSPAN_NEED_PATH(renderer, path)                                           \
    if (const std::string reason = (renderer).whyUnavailable(path); !reason.empty()) \
    GTEST_SKIP() << reason
