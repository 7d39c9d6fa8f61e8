// Which parts of two edges run together, and which point of one belongs to which of the other.
//
// Matched points are the nearest ones, to 0.6 % of the gap tolerance; between the ends of a matched part the
// parameters follow a projective map, which is exact for the reparametrizations that keep a rational curve's
// degree and third-order otherwise.
#pragma once

#include "model/friends/edge_strip.h"

namespace knotspan {

// What is told apart, in model units.
struct MatchingLengths {
    double gap = 0;       // the tolerance
    double reach = 0;     // up to here edges count as run together, if badly
    double shortest = 0;  // of a part worth naming
    double slip = 0;      // of matched points along the edge
    double point = 0;     // shorter parts of edges are as good as points
};
[[nodiscard]] MatchingLengths matchingLengths(const EdgeStrip& a, const EdgeStrip& b, double gap);

// Of one Bézier piece of each edge. With tau in [0, 1]: t = fromA + tau (toA - fromA) on a's; on b's
// fromB + phi (toB - fromB), phi / (1 - phi) = factor tau / (1 - tau). fromA < toA.
struct MatchedPart {
    size_t pieceA = 0;
    size_t pieceB = 0;
    double fromA = 0;
    double toA = 1;
    double fromB = 0;
    double toB = 1;
    double factor = 1;

    [[nodiscard]] double onA(double tau) const { return tau == 1.0 ? toA : fromA + tau * (toA - fromA); }
    [[nodiscard]] double onB(double tau) const;
    [[nodiscard]] MatchedPart between(double start, double end) const;
};

// How far matched points are apart.
[[nodiscard]] double gapAt(const EdgeStrip& a, const EdgeStrip& b, const MatchedPart& part, double tau);

// A chain of parts, a's parameter rising, each beginning where the one before ends, on both edges.
struct MatchedRun {
    std::vector<MatchedPart> parts;
    bool withinGap = true;  // somewhere, its ends included; otherwise nowhere
    // Between two parts something is not matched: more than rounding, less than a few slips.
    bool hasHole = false;
};

// All runs that are within the gap tolerance at both ends, long enough to be named, and nowhere further apart
// than the reach; and those three times as long that are within the reach only.
[[nodiscard]] std::vector<MatchedRun> matchedRuns(const EdgeStrip& a, const EdgeStrip& b,
                                                  const MatchingLengths& lengths);

}  // namespace knotspan
