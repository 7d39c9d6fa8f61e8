// Pairs of surfaces that meet along one edge, as smoothly as they were made to.
#pragma once

#include <random>

#include "model/friends/friends.h"

namespace knotspan::testing {

struct MeetingPair {
    NurbsSurface a;
    NurbsSurface b;
};

// A random surface cut at its knot nearest the middle along u, which stands there `multiplicity` times.
struct SplitShape {
    int degree = 3;
    int multiplicity = 1;
    bool rational = false;
};
[[nodiscard]] MeetingPair splitSurface(std::mt19937& random, const SplitShape& shape);

// Two curved surfaces along a straight edge, from (0, 0, 0) to (0, 4, 0), on the y axis. The second continues
// the first with all derivatives up to `order` (0, 1 or 2), is then turned by an angle around the edge, and
// moved by `away` along a direction at right angles to it.
struct HingeShape {
    int order = 2;
    bool rational = false;
    double turnDeg = 0;
    double away = 0;
};
[[nodiscard]] MeetingPair hinge(std::mt19937& random, const HingeShape& shape);

// Two parts of cones along a quarter of a circle: exactly this angle between their tangent planes, and the
// second's circle larger in radius by `away`.
[[nodiscard]] MeetingPair cones(double turnDeg, double away = 0);

// Two parts of cylinders that touch along a straight edge, of these curvatures.
[[nodiscard]] MeetingPair cylinders(double curvatureA, double curvatureB);

}  // namespace knotspan::testing
