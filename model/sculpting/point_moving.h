// An object with some of its control points elsewhere: what drags and brushes end in.
#pragma once

#include <vector>

#include "model/scene/control_point_editing.h"

namespace knotspan {

struct PointShift {
    ControlPointIndex index;
    Vec3 by{};  // in model space

    [[nodiscard]] bool operator==(const PointShift&) const = default;
};

// Weights stay; no point stands in the list twice. The same pointer where nothing moves. Fails, with a
// sentence, where a point would not be at a finite place.
[[nodiscard]] Result<SharedObject> withPointsMoved(const SharedObject& object,
                                                   const std::vector<PointShift>& shifts);

}  // namespace knotspan
