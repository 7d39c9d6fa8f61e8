// A scene meshed in parts that share no vertex.
#pragma once

#include "model/mesh/trimmed_meshing.h"

namespace knotspan {

// The surfaces that have that number.
[[nodiscard]] PlacedScene partOf(const PlacedScene& placed, const std::vector<std::uint32_t>& numbers,
                                 std::uint32_t number);

// Both as one; refuses more vertices than can be counted.
[[nodiscard]] Result<Tessellation> appended(Tessellation to, Tessellation more);

}  // namespace knotspan
