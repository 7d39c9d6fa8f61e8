// Refinements of a scene's object, by name: trim loops and the sides it shows go along.
#pragma once

#include <optional>

#include "model/refining/refinements.h"
#include "model/scene/scene_object.h"

namespace knotspan {

enum class RefinementKind {
    insertKnot,
    removeKnot,
    raiseDegree,
    lowerDegree,
    rebuild,
    split,
    reverse,
    swap,  // u and v exchanged
};

struct RefinementRequest {
    RefinementKind kind = RefinementKind::insertKnot;
    Direction direction = Direction::U;  // not of rebuild and swap
    double parameter = 0;                // of insertKnot, removeKnot, split
    double tolerance = 1e-3;             // of removeKnot, lowerDegree; in the object's own units
    NetShape shape;                      // of rebuild
};

struct RefinedObject {
    SceneObject object;                // takes the place of the one before
    std::optional<SceneObject> other;  // the second part of a split
    Deviation deviation;               // in the object's own units; 0 where the shape cannot change
};

// Fails, with a sentence, as the functions of refinements.h do, and where a trimmed surface is to be split
// beside what its loops leave, or has loops that cannot be followed. Each part of a split gets its part of
// the loops.
[[nodiscard]] Result<RefinedObject> refined(const SceneObject& object, const RefinementRequest& request);

}  // namespace knotspan
