// Friends as lines over the model: one colour a verdict, from those that people who see few colours tell
// apart, too (Okabe and Ito, 2008).
#pragma once

#include "model/friends/scene_friends.h"
#include "renderer/frame.h"

namespace knotspan {

// 0xRRGGBB.
[[nodiscard]] std::uint32_t verdictColour(Continuity continuity);
[[nodiscard]] std::uint32_t nakedColour();

// Of all edges and naked edges; where surfaces only come near each other both sides are drawn. Smooth ones
// lie under the others.
[[nodiscard]] std::vector<EdgeLine> friendLines(const SceneFriends& friends);
// Of one of them, wider: edges() are counted first, then nakedEdges().
[[nodiscard]] std::vector<EdgeLine> chosenFriendLines(const SceneFriends& friends, size_t number);

}  // namespace knotspan
