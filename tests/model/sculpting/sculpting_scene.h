// What the tests of sculpting share: surfaces with known symmetries, scenes of them, and looking at results.
#pragma once

#include <functional>

#include "model/scene/edit.h"
#include "model/sculpting/point_selection.h"

namespace knotspan::testing {

inline constexpr ObjectId kFirst{0};
inline constexpr ObjectId kSecond{1};

using Place = std::function<Vec3(int i, int j)>;

// Cubic in both directions, clamped, weights 1 unless `weightAt` says otherwise.
[[nodiscard]] NurbsSurface netOfPlaces(int countU, int countV, const Place& at,
                                       const std::function<double(int, int)>& weightAt = {});

// A wavy sheet whose control point (i, j) is the mirror image of (countU - 1 - i, j) in x = 0, to the bit.
[[nodiscard]] NurbsSurface symmetricSheet(int countU = 9, int countV = 7);

// Some scaling, turning and shearing, and a shift.
[[nodiscard]] Mat4 anyTransform();

[[nodiscard]] Scene sceneOf(const std::vector<NurbsSurface>& surfaces);

// The scene after the edit.
[[nodiscard]] Scene applied(Scene scene, Edit edit);

[[nodiscard]] Vec3 placeIn(const Scene& scene, ObjectId object, int i, int j);  // in model space

// Every control point's place in both, and the largest distance between them.
[[nodiscard]] double largestDifference(const Scene& a, const Scene& b);

}  // namespace knotspan::testing
