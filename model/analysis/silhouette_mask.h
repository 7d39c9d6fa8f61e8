// Which pixels of a picture a closed model covers for sure, found in double without the GPU: background in
// such a pixel is a leak.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/core/space.h"
#include "model/geometry/nurbs_surface.h"

namespace knotspan {

struct PixelMask {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> covered;  // 1 or 0 a pixel, rows from the top

    [[nodiscard]] bool at(int x, int y) const { return covered[index(x, y)] != 0; }
    [[nodiscard]] size_t index(int x, int y) const
    {
        return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
    }
    [[nodiscard]] size_t count() const;  // of covered pixels
};

// A surface and the matrix from its coordinates to Vulkan's clip space, depth reversed.
struct SurfaceInClip {
    const NurbsSurface& surface;
    Mat4 toClip{1.0};
};

// The pixels that show something in every picture that is within `tolerancePx` of the truth, where the
// surfaces together are a closed model without creases. Pixels near a contour are left out, also near one
// inside the model's silhouette, where one part ends in front of another: two contours may part by twice the
// tolerance. Away from contours each part of the model is a sheet that no honest error opens. What the near
// plane cuts counts as a contour.
[[nodiscard]] PixelMask silhouetteMask(std::span<const SurfaceInClip> surfaces, int width, int height,
                                       double tolerancePx);

}  // namespace knotspan
