// Squares of a KSQuad that no trim loop runs through: most places are answered by them without a curve.
#pragma once

#include <cstdint>
#include <vector>

#include "shaders/shared/trimming.glsl"

namespace knotspan {

struct TrimBox {
    gpu::vec2 low;
    gpu::vec2 high;
};

// TRIM_INSIDE or TRIM_OUTSIDE where that holds for all places of a box, else TRIM_NEAR: says so too often
// rather than too rarely. `words` from `record` on are a KSQuad's record of shaders/shared/trimming.glsl,
// squares or not; the box must not leave the KSQuad.
[[nodiscard]] gpu::uint sideOfBox(const std::vector<std::uint32_t>& words, gpu::uint record, TrimBox box);

// Adds squares to a record without: as fine as its curves ask for, along u and along v, and as many as go
// with its size.
void addSquares(std::vector<std::uint32_t>& record);

}  // namespace knotspan
