// Edge matching, piece by piece: where one Bézier piece of an edge runs along one of another.
#pragma once

#include "model/friends/edge_matching.h"

namespace knotspan {

// Relative to a's origin: b's curve, and its samples.
struct ShiftedPiece {
    std::vector<Vec4> curve;
    std::array<Vec3, kEdgeSamples> samples;
};
[[nodiscard]] ShiftedPiece shifted(const EdgePiece& piece, const Vec3& by);

// Whether boxes and tangents say already that no part worth naming runs together.
[[nodiscard]] bool plainlyApart(const EdgePiece& a, const EdgePiece& b, const MatchingLengths& lengths);

// Parts no further apart than the reach, a's parameter rising. Their piece numbers are left 0.
[[nodiscard]] std::vector<MatchedPart> matchPieces(const EdgePiece& a, const ShiftedPiece& b,
                                                   const MatchingLengths& lengths);

}  // namespace knotspan
