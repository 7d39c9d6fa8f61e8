// How smoothly two surfaces meet along a run of matched parts of their edges.
#pragma once

#include "model/friends/edge_matching.h"
#include "model/friends/friends.h"

namespace knotspan {

[[nodiscard]] FriendEdge meetingOf(const EdgeStrip& a, const EdgeStrip& b, const MatchedRun& run,
                                   const MatchingLengths& lengths, const FriendTolerances& tolerances);

}  // namespace knotspan
