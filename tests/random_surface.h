// Random but repeatable surfaces for tests: any degree, non-uniform knots with multiplicities, weights.
#pragma once

#include <random>

#include "model/geometry/nurbs_surface.h"
#include "model/scene/scene.h"

namespace knotspan::testing {

struct RandomSurfaceShape {
    int degreeU = 3;
    int degreeV = 3;
    int spans = 3;  // in each direction, before multiplicities join some
    bool rational = false;
    double offset = 0.0;     // of all coordinates, from the origin
    double spanRatio = 4.0;  // longest to shortest span, about
    bool clamped = true;
    double weightRatio = 5.0;  // heaviest and lightest weight to 1, where rational
};

[[nodiscard]] double randomBetween(std::mt19937& random, double low, double high);

[[nodiscard]] KnotVector randomKnots(std::mt19937& random, int degree, int spans, double spanRatio,
                                     bool clamped = true);

[[nodiscard]] NurbsSurface randomSurface(std::mt19937& random, const RandomSurfaceShape& shape);

// A scene of that one surface, called `name`.
[[nodiscard]] Scene sceneOf(NurbsSurface surface, const std::string& name = "surface");

}  // namespace knotspan::testing
