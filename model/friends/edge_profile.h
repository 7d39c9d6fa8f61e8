// Gap and angle along a friend edge, sampled in double: to be looked at. Verdicts do not come from here.
#pragma once

#include <optional>
#include <vector>

#include "model/friends/friends.h"
#include "model/scene/scene_object.h"

namespace knotspan {

struct EdgeSample {
    double parameter = 0;  // a's
    double gap = 0;        // to the nearest point of b's part of the edge
    // Between the tangent planes there: 0 where the surfaces run on, 180 where one folds back onto the other;
    // nothing where one has no tangent plane.
    std::optional<double> angleDeg;
};

// From one end of edge.a to the other, evenly in its parameter, at least two; and one more where the edge is
// worst, if that lies between them.
[[nodiscard]] std::vector<EdgeSample> edgeProfile(const SceneObject& a, const SceneObject& b,
                                                  const FriendEdge& edge, int samples);

// S_u x S_v in model space at a parameter of the part, of any length; zero where there is none.
[[nodiscard]] Vec3 normalOn(const SceneObject& object, const EdgePart& part, double parameter);

}  // namespace knotspan
