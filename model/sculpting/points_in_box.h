// An object's control points in a part of model space, found without transforming the others.
#pragma once

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "model/scene/scene_object.h"
#include "model/sculpting/net_size.h"

namespace knotspan {

// Calls visit(index, position in model space) for each control point in `box` (model space), in their order,
// and for some near it.
template <class Visit>
void forPointsInBox(const SceneObject& object, const Box& box, const Visit& visit)
{
    const bool stands = object.transform == Mat4(1.0);
    Box local = stands ? box : transformed(box, glm::inverse(object.transform));
    // What rounding of either transform may cost.
    const Vec3 extent =
        glm::max(glm::abs(object.surface.bounds().low), glm::abs(object.surface.bounds().high));
    const Vec3 margin =
        stands ? Vec3(0) : Vec3(1e-9 * (extent.x + extent.y + extent.z) + 1e-9 * local.diagonal());
    local = {local.low - margin, local.high + margin};
    const NetSize size = netSizeOf(object.surface);
    const std::vector<ControlPoint>& points = object.surface.controlPoints();
    for (size_t place = 0; place < points.size(); ++place) {
        const Vec3& at = points[place].position;
        if (at.x >= local.low.x && at.x <= local.high.x && at.y >= local.low.y && at.y <= local.high.y &&
            at.z >= local.low.z && at.z <= local.high.z)
            visit(size.indexAt(place), transformed(at, object.transform));
    }
}

}  // namespace knotspan
