// What the tests of the promise and of its measurement share: views from anywhere, leaks.
#pragma once

#include <random>

#include "tests/renderer/render_support.h"

namespace knotspan::testing {

// How many views a sweep takes: KNOTSPAN_SWEEP, or `few` where it is not set.
[[nodiscard]] int sweepViews(int few);
[[nodiscard]] bool isWholeSweep();

// Towards somewhere in the scene's box, from further away than it is large or from close by, with perspective
// or without. `nearest` is the least distance, of the box's diagonal.
[[nodiscard]] Camera randomCamera(std::mt19937& random, const Box& box, double nearest = 0.1);

// The available paths whose own sampling rule is the error bound, by drawing with each.
[[nodiscard]] std::vector<PathInfo> boundPaths(Renderer& renderer);

// Of a closed model that is drawn already, with `errorPx` (countLeaks).
[[nodiscard]] std::uint64_t leaks(Renderer& renderer, const Scene& scene, const Frame& frame, double errorPx);

}  // namespace knotspan::testing
