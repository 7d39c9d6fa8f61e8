// The smallest changes that satisfy linear conditions: a handful of unknown displacements at a time.
#pragma once

#include <optional>
#include <vector>

#include "model/core/space.h"

namespace knotspan {

// Sum of coefficient times displacement = right.
struct LinearCondition {
    std::vector<std::pair<int, double>> terms;  // unknown, coefficient
    Vec3 right{0};
};

// Of all displacements that satisfy the conditions those with the least sum of squares; nothing where the
// conditions contradict each other by more than `slack`. Conditions may depend on one another.
[[nodiscard]] std::optional<std::vector<Vec3>>
leastChange(int unknowns, const std::vector<LinearCondition>& conditions, double slack);

}  // namespace knotspan
