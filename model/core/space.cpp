#include "model/core/space.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

double Box::diagonal() const
{
    return isEmpty() ? 0.0 : glm::length(size());
}

void Box::add(const Vec3& point)
{
    low = glm::min(low, point);
    high = glm::max(high, point);
}

void Box::add(const Box& box)
{
    if (box.isEmpty())
        return;
    add(box.low);
    add(box.high);
}

Box transformed(const Box& box, const Mat4& transform)
{
    Box result;
    if (box.isEmpty())
        return result;
    for (int corner = 0; corner < 8; ++corner)
        result.add(transformed(Vec3((corner & 1) != 0 ? box.high.x : box.low.x,
                                    (corner & 2) != 0 ? box.high.y : box.low.y,
                                    (corner & 4) != 0 ? box.high.z : box.low.z),
                               transform));
    return result;
}

Vec3 transformed(const Vec3& point, const Mat4& transform)
{
    return Vec3(transform * Vec4(point, 1.0));
}

}  // namespace knotspan
