#include "model/making/placement.h"

#include <glm/geometric.hpp>

#include "model/making/numbers.h"

namespace knotspan {

Result<Mat4> placementMatrix(const Placement& placement)
{
    if (auto origin = requirePlace("The origin", placement.origin); !origin)
        return tl::unexpected(origin.error());
    const auto z = requireDirection("The axis", placement.axis);
    if (!z)
        return tl::unexpected(z.error());
    const auto towards = requireDirection("The direction", placement.direction);
    if (!towards)
        return tl::unexpected(towards.error());
    Vec3 x = *towards - glm::dot(*towards, *z) * *z;
    if (!(glm::length(x) > 1e-6))
        return failure("The direction runs along the axis", "Give a direction across the axis");
    x = glm::normalize(x);
    // What rounding left along the axis, which counts where the direction was nearly along it.
    x = glm::normalize(x - glm::dot(x, *z) * *z);
    return Mat4(Vec4(x, 0), Vec4(glm::cross(*z, x), 0), Vec4(*z, 0), Vec4(placement.origin, 1));
}

Result<NurbsSurface> placed(const NurbsSurface& surface, const Placement& placement)
{
    const auto matrix = placementMatrix(placement);
    if (!matrix)
        return tl::unexpected(matrix.error());
    if (surface.bounds().diagonal() < 1e-12 * glm::length(placement.origin))
        return failure("The shape is too small for a place so far from the origin",
                       "Place it nearer, or make it larger");
    std::vector<ControlPoint> points = surface.controlPoints();
    for (ControlPoint& point : points)
        point.position = transformed(point.position, *matrix);
    return NurbsSurface::create(surface.knotsU(), surface.knotsV(), std::move(points));
}

}  // namespace knotspan
