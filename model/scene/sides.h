// Which sides of a surface are drawn.
#pragma once

#include <optional>
#include <string_view>

namespace knotspan {

enum class Sides {
    automatic,  // of a closed body that is seen from outside only its outside, of all else both
    both,
    front,  // the one that S_u x S_v points to, in the object's own coordinates
    back,
};

// "automatic", "both", "front", "back".
[[nodiscard]] const char* sidesName(Sides sides);
[[nodiscard]] std::optional<Sides> findSides(std::string_view name);

}  // namespace knotspan
