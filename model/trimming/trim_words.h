// Where the text that shaders/shared/trimming.glsl shares with shaders finds its words in C++.
#pragma once

#include <cstdint>
#include <vector>

#include "shaders/shared/trimming.glsl"

namespace knotspan {

struct TrimWords {
    const std::vector<std::uint32_t>& words;

    [[nodiscard]] std::uint32_t trimWord(gpu::uint index) const { return words[index]; }
};

}  // namespace knotspan
