// A small object for tests that only need one.
#pragma once

#include "model/geometry/primitives.h"
#include "model/scene/scene_object.h"

namespace knotspan::testing {

[[nodiscard]] inline SceneObject simpleObject(const std::string& name)
{
    return {name, {}, Mat4(1.0), true, plane({0, 0, 0}, {2, 0, 0}, {0, 3, 0}), {}};
}

[[nodiscard]] inline SharedObject sharedObject(const std::string& name)
{
    return std::make_shared<const SceneObject>(simpleObject(name));
}

}  // namespace knotspan::testing
