#include "model/analysis/curvature.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

std::optional<Curvature> curvature(const SurfacePoint& point)
{
    const Vec3 cross = glm::cross(point.du, point.dv);
    const double area = glm::length(cross);
    const double lengths = glm::length(point.du) * glm::length(point.dv);
    if (!std::isfinite(area) || !(area > 1e-11 * lengths))
        return std::nullopt;
    const Vec3 normal = cross / area;

    const double e1 = glm::dot(point.du, point.du);
    const double f1 = glm::dot(point.du, point.dv);
    const double g1 = glm::dot(point.dv, point.dv);
    const double e2 = glm::dot(point.duu, normal);
    const double f2 = glm::dot(point.duv, normal);
    const double g2 = glm::dot(point.dvv, normal);
    const double squared = area * area;  // e1 g1 - f1 f1, without its cancellation

    Curvature result;
    result.gauss = (e2 * g2 - f2 * f2) / squared;
    result.mean = (e2 * g1 - 2 * f2 * f1 + g2 * e1) / (2 * squared);
    const double half = std::sqrt(std::max(0.0, result.mean * result.mean - result.gauss));
    result.largest = result.mean + half;
    result.smallest = result.mean - half;
    if (!std::isfinite(result.gauss) || !std::isfinite(result.largest) || !std::isfinite(result.smallest))
        return std::nullopt;
    return result;
}

}  // namespace knotspan
