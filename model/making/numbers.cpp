#include "model/making/numbers.h"

#include <algorithm>
#include <cmath>

namespace knotspan {

bool isFinite(const Vec3& vector)
{
    return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

Result<void> requireSize(const std::string& what, double size)
{
    if (!std::isfinite(size))
        return failure(what + " is not a finite number", "Give a number above zero");
    if (!(size > 0))
        return failure(what + " is not above zero", "Give a number above zero");
    if (size < kSmallestSize || size > kLargestSize)
        return failure(what + " is beyond what can be drawn", "Give one between 1e-60 and 1e60");
    return {};
}

Result<void> requirePlace(const std::string& what, const Vec3& place)
{
    if (!isFinite(place))
        return failure(what + " has a coordinate that is not a finite number", "Give three finite numbers");
    if (std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) > kLargestSize)
        return failure(what + " is further away than can be drawn", "Give coordinates up to 1e60");
    return {};
}

Result<Vec3> requireDirection(const std::string& what, const Vec3& direction)
{
    if (!isFinite(direction))
        return failure(what + " is not made of finite numbers", "Give three finite numbers");
    // In two steps, so that neither a very long nor a very short one is lost.
    const double greatest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (!(greatest > 0))
        return failure(what + " has no length", "Give one that is not zero");
    const Vec3 near = direction / greatest;
    return near / std::hypot(near.x, near.y, near.z);
}

}  // namespace knotspan
