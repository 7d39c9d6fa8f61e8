#include "model/analysis/curvature.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

// Also of vectors whose squares are beyond the range of double.
double length(const Vec3& vector)
{
    return std::hypot(vector.x, vector.y, vector.z);
}

}  // namespace

double figure(const Curvature& curvature, CurvatureKind kind)
{
    switch (kind) {
    case CurvatureKind::gauss:
        return curvature.gauss;
    case CurvatureKind::largest:
        return curvature.largest;
    case CurvatureKind::smallest:
        return curvature.smallest;
    case CurvatureKind::mean:
        break;
    }
    return curvature.mean;
}

std::optional<Curvature> curvature(const SurfacePoint& point)
{
    const double sizeU = length(point.du);
    const double sizeV = length(point.dv);
    if (!(sizeU > 0) || !(sizeV > 0))
        return std::nullopt;
    const Vec3 alongU = point.du / sizeU;
    const Vec3 alongV = point.dv / sizeV;
    const Vec3 cross = glm::cross(alongU, alongV);
    const double sine = length(cross);
    if (!(sine > 1e-11))
        return std::nullopt;
    const Vec3 normal = cross / sine;
    const double cosine = glm::dot(alongU, alongV);

    // The second fundamental form per unit of length along both tangents, ...
    const double uu = glm::dot(point.duu / sizeU, normal) / sizeU;
    const double uv = glm::dot(point.duv / sizeU, normal) / sizeV;
    const double vv = glm::dot(point.dvv / sizeV, normal) / sizeV;
    // ... then in the frame of alongU and what is perpendicular to it. There it is a symmetric matrix whose
    // eigenvalues are the principal curvatures; at an umbilic, too, nothing cancels.
    const double a = uu;
    const double b = (uv - cosine * uu) / sine;
    const double c = (vv - cosine * (2 * uv - cosine * uu)) / (sine * sine);

    Curvature result;
    result.mean = 0.5 * a + 0.5 * c;
    const double half = std::hypot(0.5 * a - 0.5 * c, b);
    result.largest = result.mean + half;
    result.smallest = result.mean - half;
    result.gauss = a * c - b * b;
    if (!std::isfinite(result.gauss) || !std::isfinite(result.largest) || !std::isfinite(result.smallest))
        return std::nullopt;
    return result;
}

}  // namespace knotspan
