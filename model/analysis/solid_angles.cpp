#include "model/analysis/solid_angles.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace knotspan {

void SolidAngles::addCorner(const Vec3& corner)
{
    const Vec3 at = corner - eye_;
    const Corner next{at, std::sqrt(glm::dot(at, at))};
    if (corners_ == 0)
        first_ = next;
    else if (corners_ > 1)
        add(first_, last_, next);
    last_ = next;
    ++corners_;
}

void SolidAngles::addTriangle(const Vec3& a, const Vec3& b, const Vec3& c)
{
    beginPolygon();
    addCorner(a);
    addCorner(b);
    addCorner(c);
}

void SolidAngles::add(const Corner& a, const Corner& b, const Corner& c)
{
    double sine = sign_ * glm::dot(a.at, glm::cross(b.at, c.at));
    const double cosine = a.distance * b.distance * c.distance + glm::dot(a.at, b.at) * c.distance +
                          glm::dot(a.at, c.at) * b.distance + glm::dot(b.at, c.at) * a.distance;
    const double size = std::sqrt(sine * sine + cosine * cosine);
    // Half the angle is half a turn: on the triangle itself. Also where a number is none.
    constexpr double kOnIt = 1e-9;
    if (!(size > 0) || (cosine < 0 && std::abs(sine) < kOnIt * size)) {
        certain_ = false;
        return;
    }
    constexpr double kNothing = 1e-30;  // so that signs outlive the products
    if (std::abs(sine) < kNothing * size)
        sine = 0;
    const double im = sine / size;
    const double re = cosine / size;
    const std::complex<double> sum(direction_.real() * re - direction_.imag() * im,
                                   direction_.real() * im + direction_.imag() * re);
    if (direction_.imag() >= 0 && im >= 0 && sum.imag() < 0)
        ++turns_;
    else if (direction_.imag() < 0 && im < 0 && sum.imag() >= 0)
        --turns_;
    direction_ = sum;
}

std::optional<double> SolidAngles::turns() const
{
    if (!certain_)
        return std::nullopt;
    return turns_ + std::atan2(direction_.imag(), direction_.real()) / (2 * std::numbers::pi);
}

std::optional<int> SolidAngles::wholeTurns(double turns)
{
    constexpr double kWhole = 0.01;
    const double whole = std::round(turns);
    if (!(std::abs(turns - whole) < kWhole) || std::abs(whole) > 1e9)
        return std::nullopt;
    return static_cast<int>(whole);
}

}  // namespace knotspan
