#include "model/scene/control_point_editing.h"

#include <cmath>

#include <glm/matrix.hpp>

#include "model/core/check.h"

namespace knotspan {

namespace {

void requireInside(const SceneObject& object, ControlPointIndex index)
{
    check(index.i >= 0 && index.i < object.surface.countU() && index.j >= 0 &&
              index.j < object.surface.countV(),
          "the control point's index lies inside the net");
}

}  // namespace

Vec3 controlPointInModel(const SceneObject& object, ControlPointIndex index)
{
    requireInside(object, index);
    return transformed(object.surface.controlPoint(index.i, index.j).position, object.transform);
}

Result<SharedObject> withControlPointAt(const SceneObject& object, ControlPointIndex index,
                                        const Vec3& position)
{
    requireInside(object, index);
    // The identity must not cost the last bit.
    const Vec3 local =
        object.transform == Mat4(1.0) ? position : transformed(position, glm::inverse(object.transform));
    if (!std::isfinite(local.x) || !std::isfinite(local.y) || !std::isfinite(local.z))
        return failure("The control point would go infinitely far away", "Drag it less far");
    std::vector<ControlPoint> points = object.surface.controlPoints();
    points[static_cast<size_t>(index.i) * static_cast<size_t>(object.surface.countV()) +
           static_cast<size_t>(index.j)]
        .position = local;
    auto surface = NurbsSurface::create(object.surface.knotsU(), object.surface.knotsV(), std::move(points));
    if (!surface)
        return tl::unexpected(surface.error());
    auto changed = std::make_shared<SceneObject>(object);
    changed->surface = *std::move(surface);
    return changed;
}

}  // namespace knotspan
