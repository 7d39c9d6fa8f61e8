// Which control points follow a drag of the selected ones, and by which share.
#pragma once

#include <map>

#include "model/sculpting/point_selection.h"

namespace knotspan {

// With t = 1 at the selected point and 0 at the radius; the names are Blender's.
enum class FalloffShape {
    smooth,    // 3 t^2 - 2 t^3
    sphere,    // sqrt(2 t - t^2)
    linear,    // t
    sharp,     // t^2
    constant,  // 1
};

// 1 where `distance` is 0, 0 where it is `radius` or more; 0 where either is no number.
[[nodiscard]] double falloffShare(FalloffShape shape, double distance, double radius);

enum class FalloffDistance {
    space,       // straight to the nearest selected control point, of whichever object
    netSteps,    // along the lines of the object's own net, each counting 1
    netLengths,  // along the same lines, by their length
};

struct Falloff {
    double radius = 0;  // in model units, or steps; 0: only the selected points move
    FalloffShape shape = FalloffShape::smooth;
    FalloffDistance distance = FalloffDistance::space;

    [[nodiscard]] bool operator==(const Falloff&) const = default;
};

struct Follower {
    ControlPointIndex index;
    double share = 1;  // of the way that the selected points go: above 0, up to 1

    [[nodiscard]] bool operator==(const Follower&) const = default;
};
// By object, in the order of comesBefore(); no list is empty.
using Followers = std::map<ObjectId, std::vector<Follower>>;

// The selected points, each with share 1, and those that follow them, of the objects with selected points; by
// distance in space those of `others` too. The selection is of this scene (PointSelection::keepOnly).
[[nodiscard]] Followers followersOf(const Scene& scene, const PointSelection& selection,
                                    const Falloff& falloff, const std::set<ObjectId>& others = {});

}  // namespace knotspan
