#include "model/mesh/triangle_in_ksquad.h"

#include <algorithm>

#include <glm/common.hpp>

namespace knotspan {

Vec2 TriangleInKsquad::size() const
{
    return glm::max(glm::max(t[0], t[1]), t[2]) - glm::min(glm::min(t[0], t[1]), t[2]);
}

TriangleInKsquad inKsquad(const std::array<OutlinePlace, 3>& corners, const FacePlane& plane,
                          const FaceErrors& errors)
{
    Vec2 middle(0.0);
    for (const OutlinePlace& corner : corners)
        middle += corner.onLattice() / 3.0;
    TriangleInKsquad result;
    result.a = std::clamp(static_cast<int>(middle.x), plane.first(0), plane.last(0));
    result.b = std::clamp(static_cast<int>(middle.y), plane.first(1), plane.last(1));
    for (size_t k = 0; k < corners.size(); ++k) {
        const Vec2 t = Vec2(corners[k].a - result.a, corners[k].b - result.b) + corners[k].t;
        result.t[k] = glm::clamp(t, Vec2(0.0), Vec2(1.0));
        if (t != result.t[k])
            result.spills = std::max(result.spills, errors.spill(result.a, result.b, corners[k]));
    }
    return result;
}

}  // namespace knotspan
