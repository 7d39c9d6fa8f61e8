// Creases inside a surface: knot lines, of knots that stand as often as the degree, across which it is not
// G1.
#pragma once

#include "model/friends/friends.h"

namespace knotspan {

struct Crease {
    Direction across = Direction::U;
    double parameter = 0;
    double angleMaxDeg = 0;  // attained somewhere along it
};

// Those that meet no better than G0 within the tolerances, u first, each increasing.
[[nodiscard]] std::vector<Crease> creasesOf(const PlacedSurface& placed, const FriendTolerances& tolerances);

}  // namespace knotspan
