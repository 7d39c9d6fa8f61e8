#include "model/sculpting/point_moving.h"

#include "model/sculpting/with_points.h"

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/core/check.h"
#include "model/sculpting/net_size.h"

namespace knotspan {

Result<SharedObject> withPointsMoved(const SharedObject& object, const std::vector<PointShift>& shifts)
{
    if (std::all_of(shifts.begin(), shifts.end(), [](const PointShift& one) { return one.by == Vec3(0); }))
        return object;
    const NetSize size = netSizeOf(object->surface);
    const bool stands = object->transform == Mat4(1.0);  // the identity must not cost the last bit
    const glm::dmat3 toObject = stands ? glm::dmat3(1.0) : glm::inverse(glm::dmat3(object->transform));
    std::vector<ControlPoint> points = object->surface.controlPoints();
    for (const PointShift& shift : shifts) {
        check(size.contains(shift.index), "the control point's index lies inside the net");
        Vec3& position = points[size.place(shift.index)].position;
        position += stands ? shift.by : toObject * shift.by;
        if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z))
            return failure("A control point would go infinitely far away", "Drag it less far");
    }
    return withPoints(*object, std::move(points));
}

}  // namespace knotspan
