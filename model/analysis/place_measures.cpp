#include "model/analysis/place_measures.h"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

namespace knotspan {

namespace {

double length(const Vec3& vector)
{
    return std::hypot(vector.x, vector.y, vector.z);
}

std::optional<Vec3> frontOf(const NurbsSurface& surface, const glm::dmat3& linear, double u, double v)
{
    const SurfaceNormal own = evaluateNormal(surface, u, v);
    if (!own.exists)
        return std::nullopt;
    // Normals go with the cofactors; the sign of the determinant is the mirror's.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const Vec3 front = cofactors * own.direction;
    const double size = length(front);
    if (!(size > 0) || !std::isfinite(size))
        return std::nullopt;
    return glm::determinant(linear) < 0 ? -front / size : front / size;
}

}  // namespace

SurfacePoint placed(const SurfacePoint& point, const Mat4& transform)
{
    const glm::dmat3 linear(transform);
    return {transformed(point.position, transform),
            linear * point.du,
            linear * point.dv,
            linear * point.duu,
            linear * point.duv,
            linear * point.dvv};
}

PlaceMeasures measuresAt(const NurbsSurface& surface, const Mat4& transform, double u, double v)
{
    const SurfacePoint point = placed(evaluate(surface, u, v), transform);
    const glm::dmat3 linear(transform);
    PlaceMeasures found{point.position, frontOf(surface, linear, u, v), curvature(point),
                        principalDirections(point)};
    if (glm::determinant(linear) < 0) {
        if (Curvature* const bend = found.curvature ? &*found.curvature : nullptr)
            *bend = {bend->gauss, -bend->mean, -bend->smallest, -bend->largest};
        if (found.directions)
            std::swap(found.directions->largest, found.directions->smallest);
    }
    return found;
}

Separation separation(const PlaceMeasures& from, const PlaceMeasures& to)
{
    const Vec3 difference = to.position - from.position;
    Separation found{length(difference), difference, std::nullopt};
    if (from.normal && to.normal)
        found.normalsDeg = angleDeg(*from.normal, *to.normal);
    return found;
}

std::optional<double> angleDeg(const Vec3& a, const Vec3& b)
{
    const double sizeA = length(a);
    const double sizeB = length(b);
    if (!(sizeA > 0) || !(sizeB > 0))
        return std::nullopt;
    const Vec3 alongA = a / sizeA;
    const Vec3 alongB = b / sizeB;
    // Right to the last digits near 0 and 180, too.
    return glm::degrees(2 * std::atan2(length(alongA - alongB), length(alongA + alongB)));
}

std::optional<double> angleAtDeg(const Vec3& middle, const Vec3& one, const Vec3& other)
{
    return angleDeg(one - middle, other - middle);
}

}  // namespace knotspan
