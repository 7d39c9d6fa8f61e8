// What a hand draws over the picture (boxes, lassos, curves), as strokes.
#pragma once

#include <vector>

#include "renderer/frame.h"

namespace knotspan {

[[nodiscard]] Stroke handStroke(const Vec2& from, const Vec2& to, double pixelRatio, float opacity = 1);

// Along the corners and back to the first one; that last stroke is not always the hand's own.
void addClosed(const std::vector<Vec2>& corners, double pixelRatio, float closingOpacity,
               std::vector<Stroke>& to);

}  // namespace knotspan
