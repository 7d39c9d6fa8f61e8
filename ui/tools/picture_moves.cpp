#include "ui/tools/picture_moves.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace knotspan {

namespace {

// On the picture, y down, and away from the eye.
Vec3 seen(const Camera& camera, const Vec3& direction)
{
    return {glm::dot(direction, camera.right()), -glm::dot(direction, camera.upward()),
            glm::dot(direction, camera.forward())};
}

}  // namespace

Vec3 movedInViewPlane(const PictureView& view, const Vec3& start, const Vec2& way)
{
    const Camera& camera = view.camera;
    return (camera.right() * way.x - camera.upward() * way.y) * camera.unitsPerPixel(start, view.height);
}

Result<double> movedAlong(const PictureView& view, const Vec3& start, const Vec3& axis, const Vec2& way)
{
    const Camera& camera = view.camera;
    const Vec3 along = seen(camera, axis);
    const Vec3 place = seen(camera, start - camera.eye);
    // Seen from the eye, what goes away also goes towards the middle.
    const double receding = camera.orthographic ? 0 : along.z / place.z;
    const Vec2 onPicture = Vec2(along) - Vec2(place) * receding;
    const double length = glm::length(onPicture);
    constexpr double kLeast = 0.02;
    if (!(length >= kLeast))
        return failure("The axis points at the eye", "Turn the view, or choose another axis");
    const double wanted = glm::dot(way, onPicture) / length * camera.unitsPerPixel(start, view.height);
    const double left = length - wanted * receding;
    if (!(left > kLeast * length))
        return failure("The axis ends in the distance before the hand", "Drag less far, or turn the view");
    return wanted / left;
}

RingSeen::RingSeen(const Camera& camera, const Vec3& axis)
{
    const Vec3 other = std::abs(axis.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 b = glm::normalize(glm::cross(axis, other));
    const Vec3 one = seen(camera, glm::cross(b, axis));
    const Vec3 two = seen(camera, b);
    first = Vec2(one);
    second = Vec2(two);
    firstDepth = one.z;
    secondDepth = two.z;
}

Vec2 RingSeen::at(double radians) const
{
    return std::cos(radians) * first + std::sin(radians) * second;
}

double RingSeen::depthAt(double radians) const
{
    return std::cos(radians) * firstDepth + std::sin(radians) * secondDepth;
}

bool RingSeen::isEdgeOn() const
{
    constexpr double kLeast = 0.2;
    return std::abs(first.x * second.y - first.y * second.x) < kLeast;
}

double turnedBy(const PictureView& view, const Vec3& axis, const Vec2& from, const Vec2& way, double radiusPx,
                double last)
{
    const RingSeen ring(view.camera, axis);
    if (ring.isEdgeOn()) {
        // As on a wheel seen from its side: the place that is nearest to the eye goes with the hand.
        const double nearest = std::atan2(-ring.secondDepth, -ring.firstDepth);
        const Vec2 tangent = glm::normalize(std::cos(nearest) * ring.second - std::sin(nearest) * ring.first);
        return glm::degrees(glm::dot(way, tangent) / radiusPx);
    }
    const double area = ring.first.x * ring.second.y - ring.first.y * ring.second.x;
    const auto angleAt = [&](const Vec2& place) {
        const double x = (place.x * ring.second.y - place.y * ring.second.x) / area;
        const double y = (ring.first.x * place.y - ring.first.y * place.x) / area;
        return glm::degrees(std::atan2(y, x));
    };
    const double angle = angleAt(from + way) - angleAt(from);
    return angle + 360 * std::round((last - angle) / 360);
}

}  // namespace knotspan
