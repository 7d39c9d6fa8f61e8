// The objects around some of a scene: what an edit at their edges can have to do with.
#pragma once

#include <map>
#include <set>

#include "model/friends/scene_friends.h"

namespace knotspan {

// The objects given (0 steps away), the visible ones that they may touch (1), the ones those may touch, and
// so on, judged by boxes that grow by `gap`. Never misses one whose edge runs along within the gap.
[[nodiscard]] std::map<ObjectId, int> neighbours(const Scene& scene, const std::set<ObjectId>& of, int steps,
                                                 double gap);

// A scene of those alone, under the same ids.
[[nodiscard]] Scene partOf(const Scene& scene, const std::map<ObjectId, int>& objects);

// How a sentence calls an object: its name, or its number where it has none.
[[nodiscard]] std::string nameOf(const Scene& scene, ObjectId id);

}  // namespace knotspan
