// The pieces of trim loops in a KSQuad, sorted for quick questions: bands of v and in each cells of u
// (shaders/shared/trimming.glsl).
#pragma once

#include <optional>

#include "model/trimming/float_piece.h"

namespace knotspan {

// More are too intricate to be drawn.
constexpr size_t kMostTrimEntries = size_t{1} << 21U;

// Heights at which an odd number of curves begins or ends: increasing.
using Toggles = std::vector<float>;
void normalise(Toggles& toggles);

class KsQuadBands {
public:
    // `left`: where curves along the left border, and left of it, begin and end.
    KsQuadBands(std::vector<FloatPiece> pieces, const Toggles& left, bool startsInside);

    [[nodiscard]] size_t entries() const { return entries_; }
    // The most that one answer looks at.
    [[nodiscard]] std::uint32_t mostPieces() const;
    // Whether all of the KSQuad is inside, or outside.
    [[nodiscard]] std::optional<bool> uniform() const;
    // The KSQuad's record, without squares: its first word is 0.
    [[nodiscard]] std::vector<std::uint32_t> record() const;

private:
    struct Cell {
        float left, right;
        std::vector<std::uint32_t> pieces;
    };
    struct Band {
        float bottom, top;
        std::vector<std::uint32_t> pieces;
        std::vector<Cell> cells;

        [[nodiscard]] double cost() const;
        [[nodiscard]] size_t entries() const;
    };

    void makeBands();
    void halve();
    [[nodiscard]] bool leftInside(const Band& band) const;
    [[nodiscard]] Band made(float bottom, float top, const std::vector<std::uint32_t>& candidates) const;
    [[nodiscard]] bool isOdd(const Cell& cell, const Band& band) const;
    [[nodiscard]] float middleOf(const Band& band) const;

    std::vector<FloatPiece> pieces_;
    const Toggles& left_;
    bool startsInside_;
    std::vector<Band> bands_;
    size_t entries_ = 0;
};

}  // namespace knotspan
