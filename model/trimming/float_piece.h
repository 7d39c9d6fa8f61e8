// A piece of a trimmed region in floats, as the words of shaders/shared/trimming.glsl have it.
#pragma once

#include "model/trimming/trim_region.h"

namespace knotspan {

[[nodiscard]] std::uint32_t bitsOf(float number);

struct FloatPiece {
    std::vector<std::uint32_t> words;
    float lowX, highX, lowY, highY;
    std::vector<TrimPoint> points;  // the floats; the ends' weights are 1

    explicit FloatPiece(const RegionPiece& piece);

    // Along u, where it may be in a band: a little more than the curve's own part.
    [[nodiscard]] std::pair<float, float> within(float bottom, float top) const;

private:
    [[nodiscard]] float at(float y) const;
};

}  // namespace knotspan
