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

// The second fundamental form in the frame of a unit vector along S_u and what is perpendicular to it: a
// symmetric matrix whose eigenvalues are the principal curvatures; at an umbilic, too, nothing cancels.
struct SecondForm {
    Vec3 alongU{0};
    Vec3 across{0};  // alongU, across and the normal are right-handed
    double a = 0;
    double b = 0;  // off the diagonal
    double c = 0;

    [[nodiscard]] double half() const { return std::hypot(0.5 * a - 0.5 * c, b); }
};

std::optional<SecondForm> secondForm(const SurfacePoint& point)
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
    // First per unit of length along both tangents.
    const double uu = glm::dot(point.duu / sizeU, normal) / sizeU;
    const double uv = glm::dot(point.duv / sizeU, normal) / sizeV;
    const double vv = glm::dot(point.dvv / sizeV, normal) / sizeV;
    return SecondForm{alongU, glm::cross(normal, alongU), uu, (uv - cosine * uu) / sine,
                      (vv - cosine * (2 * uv - cosine * uu)) / (sine * sine)};
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
    const auto form = secondForm(point);
    if (!form)
        return std::nullopt;
    Curvature result;
    result.mean = 0.5 * form->a + 0.5 * form->c;
    const double half = form->half();
    result.largest = result.mean + half;
    result.smallest = result.mean - half;
    result.gauss = form->a * form->c - form->b * form->b;
    if (!std::isfinite(result.gauss) || !std::isfinite(result.largest) || !std::isfinite(result.smallest))
        return std::nullopt;
    return result;
}

std::optional<PrincipalDirections> principalDirections(const SurfacePoint& point)
{
    const auto form = secondForm(point);
    if (!form)
        return std::nullopt;
    const double half = form->half();
    if (!std::isfinite(half) || !(half > 1e-10 * std::abs(0.5 * form->a + 0.5 * form->c)))
        return std::nullopt;
    const double angle = 0.5 * std::atan2(form->b, 0.5 * form->a - 0.5 * form->c);
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    return PrincipalDirections{x * form->alongU + y * form->across, x * form->across - y * form->alongU};
}

}  // namespace knotspan
