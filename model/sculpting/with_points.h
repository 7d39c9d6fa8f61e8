// An object whose net has the same size and other control points.
#pragma once

#include "model/scene/scene_object.h"

namespace knotspan {

// Refuses, with a sentence, what NurbsSurface::create() refuses.
[[nodiscard]] inline Result<SharedObject> withPoints(const SceneObject& object,
                                                     std::vector<ControlPoint> points)
{
    auto surface = NurbsSurface::create(object.surface.knotsU(), object.surface.knotsV(), std::move(points));
    if (!surface)
        return tl::unexpected(surface.error());
    auto changed = std::make_shared<SceneObject>(object);
    changed->surface = *std::move(surface);
    return changed;
}

}  // namespace knotspan
