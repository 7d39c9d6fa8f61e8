#include "ui/viewport/navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace knotspan {

namespace {

constexpr double kZoomPerStep = 1.2;

}  // namespace

Camera orbited(Camera camera, const Vec2& way, const PictureSize& size)
{
    const double radians = std::numbers::pi / std::max(size.height, 1);
    camera.orbit(-way.x * radians, way.y * radians);
    return camera;
}

Camera panned(Camera camera, const Vec2& way, const PictureSize& size)
{
    const double unit = camera.unitsPerPixel(camera.target, size.height);
    camera.pan(-way.x * unit, way.y * unit);
    return camera;
}

Camera zoomed(Camera camera, double steps, const Vec2& cursor, const PictureSize& size)
{
    const double unit = camera.unitsPerPixel(camera.target, size.height);
    const Vec2 fromCentre((cursor.x - size.width / 2.0) * unit, (size.height / 2.0 - cursor.y) * unit);
    camera.zoomAt(std::pow(kZoomPerStep, -steps), fromCentre);
    return camera;
}

Camera closeTo(Camera camera, const Vec3& point, double units, const Vec3& outward)
{
    constexpr double kLeastFacing = 0.35;  // cosine
    Vec3 forward = camera.forward();
    const double length = glm::length(outward);
    if (length > 0 && glm::dot(forward, outward) > -kLeastFacing * length) {
        forward = -outward / length;
        // Not along what is up.
        const Vec3 up = glm::normalize(camera.up);
        if (std::abs(glm::dot(forward, up)) > 0.95)
            forward =
                glm::normalize(forward + 0.5 * (camera.forward() - up * glm::dot(camera.forward(), up)) +
                               0.01 * camera.right());
    }
    const double distance = units / std::tan(glm::radians(camera.verticalFovDegrees) * 0.5);
    camera.target = point;
    camera.eye = point - forward * distance;
    return camera;
}

}  // namespace knotspan
