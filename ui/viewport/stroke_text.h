// Short texts made of strokes, for what is said in the picture itself: the presenters show no widgets over
// it.
#pragma once

#include <string_view>

#include "renderer/frame.h"

namespace knotspan {

struct StrokeTextStyle {
    double height = 10;  // of capitals, pixels
    double width = 1.4;  // of a line, pixels
    std::uint32_t colour = kHoverColour;
    std::uint32_t halo = 0x101317;  // around it, so that it reads on anything
};

// Capitals, digits and some signs; small letters are drawn as capitals, anything else as a space. `across`
// and `down` are how far a text goes for one pixel of its width and of its height: (1, 0) and (0, 1) where it
// stands upright.
struct StrokeTextPlace {
    Vec2 corner{0};  // the upper left one
    Vec2 across{1, 0};
    Vec2 down{0, 1};
};

[[nodiscard]] double strokeTextWidth(std::string_view text, double height);
void addStrokeText(std::vector<Stroke>& to, std::string_view text, const StrokeTextPlace& place,
                   const StrokeTextStyle& style);

}  // namespace knotspan
