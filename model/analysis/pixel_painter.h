// The pixels whose centres lie in triangles, and those near lines: what silhouette_mask.h is made with.
#pragma once

#include "model/analysis/silhouette_mask.h"

namespace knotspan {

// Points are homogeneous pixels (ScreenView::toPixels); what is behind the near plane is cut off.
class PixelPainter {
public:
    // `margin` pixels around lines, and around whatever is not covered, are not in the mask.
    PixelPainter(int width, int height, double margin);

    // Triangles that touch may leave gaps of a tenth of a pixel.
    void cover(const Vec4& a, const Vec4& b, const Vec4& c);
    void keepOff(Vec4 a, Vec4 b);

    [[nodiscard]] PixelMask mask() const;

private:
    // The pixels whose centres may be within `reach` of a box, and inside the picture: from first to end.
    struct PixelRange {
        int firstX = 0, endX = 0, firstY = 0, endY = 0;
    };
    [[nodiscard]] PixelRange pixelsAround(Vec2 low, Vec2 high, double reach) const;
    void coverConvex(const std::vector<Vec2>& corners);
    void keepOff(const Vec2& a, const Vec2& b, std::vector<std::uint8_t>& kept) const;

    double margin_;
    PixelMask covered_;
    std::vector<std::uint8_t> keptOff_;
};

}  // namespace knotspan
