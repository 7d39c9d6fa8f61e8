// A trimmed region for quick questions, in float: what shaders/shared/trimming.glsl reads, and the same for
// C++.
#pragma once

#include <cstdint>

#include "model/trimming/trim_region.h"

namespace knotspan {

enum class KsQuadTrim { inside, outside, cut };

class TrimIndex {
public:
    // Refuses, with a sentence, loops so intricate that more than 2^21 entries would be needed.
    [[nodiscard]] static Result<TrimIndex> create(const TrimRegion& region);

    // One word for each KSQuad (number a countV + b), at least three, then the records. To stand behind other
    // words, record starts (what is not below TRIM_RECORDS) count from the first word here.
    [[nodiscard]] const std::vector<std::uint32_t>& words() const { return words_; }
    [[nodiscard]] std::uint32_t ksquadCount() const { return ksquads_; }
    [[nodiscard]] KsQuadTrim classOf(std::uint32_t ksquad) const;
    [[nodiscard]] bool contains(std::uint32_t ksquad, float x, float y) const;
    // What all places of the KSQuad within `reach` have in common: inside, outside, or maybe neither.
    [[nodiscard]] KsQuadTrim sideOf(std::uint32_t ksquad, const Vec2& place, const Vec2& reach) const;
    // The most pieces that one answer looks at.
    [[nodiscard]] std::uint32_t mostPieces() const { return mostPieces_; }

private:
    std::vector<std::uint32_t> words_;
    std::uint32_t ksquads_ = 0;
    std::uint32_t mostPieces_ = 0;
};

}  // namespace knotspan
