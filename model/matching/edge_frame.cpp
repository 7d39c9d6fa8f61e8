#include "model/matching/edge_frame.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

EdgeFrame frameInto(const NurbsSurface& edgeFirst, double v)
{
    const SurfacePoint at = evaluate(edgeFirst, edgeFirst.knotsU().domainStart(), v);
    EdgeFrame frame;
    frame.point = at.position;
    const double speed = glm::length(at.dv);
    if (!(speed > 0))
        return frame;
    frame.along = at.dv / speed;
    const double skew = glm::dot(at.du, frame.along);
    const Vec3 beside = at.du - skew * frame.along;
    const double width = glm::length(beside);
    if (!(width > 1e-9 * glm::length(at.du)))
        return frame;
    frame.across = beside / width;
    frame.normal = glm::cross(frame.along, frame.across);
    frame.regular = true;

    // du = skew along + width across, so its form is a sum of the three.
    frame.alongAlong = glm::dot(at.dvv, frame.normal) / (speed * speed);
    frame.alongAcross = (glm::dot(at.duv, frame.normal) / speed - skew * frame.alongAlong) / width;
    frame.acrossAcross = (glm::dot(at.duu, frame.normal) - skew * skew * frame.alongAlong -
                          2 * skew * width * frame.alongAcross) /
                         (width * width);
    return frame;
}

EdgeFrame turned(const EdgeFrame& frame)
{
    EdgeFrame result = frame;
    result.across = -frame.across;
    result.normal = -frame.normal;
    result.alongAlong = -frame.alongAlong;
    result.acrossAcross = -frame.acrossAcross;
    return result;
}

double breakDeg(const EdgeFrame& first, const EdgeFrame& second)
{
    if (!first.regular || !second.regular)
        return 180;
    const double sine = glm::length(glm::cross(first.normal, second.normal));
    return std::atan2(sine, glm::dot(first.normal, second.normal)) * 180 / std::numbers::pi;
}

}  // namespace knotspan
