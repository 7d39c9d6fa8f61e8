#include "ui/tools/hand_strokes.h"

namespace knotspan {

namespace {

constexpr std::uint32_t kColour = 0xffc861;

}  // namespace

Stroke handStroke(const Vec2& from, const Vec2& to, double pixelRatio, float opacity)
{
    const auto width = static_cast<float>(2 * pixelRatio);
    return {.from = from,
            .to = to,
            .colour = kColour,
            .widthFromPx = width,
            .widthToPx = width,
            .opacity = opacity};
}

void addClosed(const std::vector<Vec2>& corners, double pixelRatio, float closingOpacity,
               std::vector<Stroke>& to)
{
    for (size_t k = 0; k + 1 < corners.size(); ++k)
        to.push_back(handStroke(corners[k], corners[k + 1], pixelRatio));
    if (!corners.empty())
        to.push_back(handStroke(corners.back(), corners.front(), pixelRatio, closingOpacity));
}

}  // namespace knotspan
