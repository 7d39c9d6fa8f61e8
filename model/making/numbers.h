// What all that is made from typed numbers asks of them.
#pragma once

#include "model/core/result.h"
#include "model/core/space.h"

namespace knotspan {

// Sizes and coordinates stay within these, so that no product of a few of them leaves the range of double.
constexpr double kSmallestSize = 1e-60;
constexpr double kLargestSize = 1e60;

[[nodiscard]] bool isFinite(const Vec3& vector);

// Of the kind "The radius": refuses what is not finite, not above zero, or beyond the bounds above.
[[nodiscard]] Result<void> requireSize(const std::string& what, double size);

// Refuses a place that is not finite or further than kLargestSize from the origin.
[[nodiscard]] Result<void> requirePlace(const std::string& what, const Vec3& place);

// The unit vector of that direction, of whatever length; refuses one that is not finite or zero.
[[nodiscard]] Result<Vec3> requireDirection(const std::string& what, const Vec3& direction);

}  // namespace knotspan
