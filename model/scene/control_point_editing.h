// Pure functions from an object to the object with some control points changed: what the tools are made of.
#pragma once

#include "model/scene/scene_object.h"

namespace knotspan {

// Names one control point of a surface's net.
struct ControlPointIndex {
    int i = 0;  // along u
    int j = 0;  // along v

    [[nodiscard]] bool operator==(const ControlPointIndex&) const = default;
};

// Where the control point stands in model space.
[[nodiscard]] Vec3 controlPointInModel(const SceneObject& object, ControlPointIndex index);

// The object with that control point at `position` (model space), its weight unchanged. Fails where the
// position is not finite.
[[nodiscard]] Result<SharedObject> withControlPointAt(const SceneObject& object, ControlPointIndex index,
                                                      const Vec3& position);

}  // namespace knotspan
