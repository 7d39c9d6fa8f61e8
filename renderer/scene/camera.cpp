#include "renderer/scene/camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace knotspan {

namespace {

constexpr double kNearest = 1e-4;  // the near plane, of the distance to the target

// A unit vector orthogonal to `forward`, near `wanted` or, where that is along the view, anything.
Vec3 orthogonalTo(const Vec3& forward, const Vec3& wanted)
{
    Vec3 right = glm::cross(forward, wanted);
    if (!(glm::length(right) > 1e-12 * glm::length(wanted)))
        right = glm::cross(forward, std::abs(forward.x) < 0.9 ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
    return glm::normalize(right);
}

double halfHeightAtTarget(const Camera& camera)
{
    return camera.distance() * std::tan(glm::radians(camera.verticalFovDegrees) * 0.5);
}

Vec3 rotated(const Vec3& v, const Vec3& axis, double angle)
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1.0 - c));
}

}  // namespace

Vec3 Camera::forward() const
{
    const Vec3 view = target - eye;
    const double length = glm::length(view);
    return length > 0.0 ? view / length : Vec3(0, 1, 0);
}

Vec3 Camera::right() const
{
    return orthogonalTo(forward(), up);
}

Vec3 Camera::upward() const
{
    return glm::cross(right(), forward());
}

double Camera::distance() const
{
    return glm::length(target - eye);
}

double Camera::unitsPerPixel(const Vec3& point, int pictureHeight) const
{
    const double height = 2.0 * halfHeightAtTarget(*this) / pictureHeight;
    if (orthographic)
        return height;
    return height * std::max(glm::dot(point - eye, forward()), 1e-9 * distance()) / distance();
}

Mat4 Camera::rotation() const
{
    const Vec3 r = right();
    const Vec3 u = upward();
    const Vec3 b = -forward();
    return {Vec4(r.x, u.x, b.x, 0), Vec4(r.y, u.y, b.y, 0), Vec4(r.z, u.z, b.z, 0), Vec4(0, 0, 0, 1)};
}

Mat4 Camera::viewFrom(const Mat4& transform, const Vec3& origin) const
{
    const Mat4 turned = rotation();
    Mat4 toView = turned * transform;
    toView[3] = turned * Vec4(transformed(origin, transform) - eye, 1.0);
    return toView;
}

Mat4 Camera::projection(double aspect, const Box& bounds) const
{
    Mat4 matrix(0.0);
    if (orthographic) {
        const double half = halfHeightAtTarget(*this);
        const double radius = std::max(bounds.diagonal(), 1e-6 * distance());
        const double depth = bounds.isEmpty() ? distance() : glm::dot(bounds.centre() - eye, forward());
        matrix[0][0] = 1.0 / (half * aspect);
        matrix[1][1] = -1.0 / half;
        matrix[2][2] = 1.0 / (2.0 * radius);
        matrix[3][2] = (depth + radius) / (2.0 * radius);
        matrix[3][3] = 1.0;
        return matrix;
    }
    // Reversed depth without a far plane: float depth keeps its digits far away, so the near plane may be
    // very near.
    const double f = 1.0 / std::tan(glm::radians(verticalFovDegrees) * 0.5);
    matrix[0][0] = f / aspect;
    matrix[1][1] = -f;
    matrix[2][3] = -1.0;
    matrix[3][2] = kNearest * std::max(distance(), 1e-30);
    return matrix;
}

double Camera::cutOff(double aspect, const Box& bounds) const
{
    if (orthographic) {
        const double radius = std::max(bounds.diagonal(), 1e-6 * distance());
        return (bounds.isEmpty() ? glm::dot(target, forward()) : glm::dot(bounds.centre(), forward())) -
               radius;
    }
    const double slope = std::tan(glm::radians(verticalFovDegrees) * 0.5);
    return kNearest * std::max(distance(), 1e-30) * std::sqrt(1.0 + slope * slope * (1.0 + aspect * aspect));
}

std::optional<Vec2> Camera::toPixel(const Vec3& point, int width, int height) const
{
    return PixelProjection(*this, width, height)(point);
}

PixelProjection::PixelProjection(const Camera& camera, int width, int height)
    : rotation_(camera.rotation()),
      eye_(camera.eye),
      middle_(0.5 * width, 0.5 * height),
      nearest_(kNearest * camera.distance()),
      scale_(0.5 * height / std::tan(glm::radians(camera.verticalFovDegrees) * 0.5)),
      depth_(camera.orthographic ? std::optional(camera.distance()) : std::nullopt)
{
}

std::optional<Vec2> PixelProjection::operator()(const Vec3& point) const
{
    const Vec3 view = Vec3(rotation_ * Vec4(point - eye_, 0.0));
    const double depth = depth_.value_or(-view.z);
    if (!(depth > nearest_))
        return std::nullopt;
    return middle_ + Vec2(view.x, -view.y) * (scale_ / depth);
}

void Camera::orbit(double yawRadians, double pitchRadians)
{
    up = Vec3(0, 0, 1);
    Vec3 offset = rotated(eye - target, Vec3(0, 0, 1), yawRadians);
    const double length = glm::length(offset);
    // Stops short of the poles, where the view would turn over.
    constexpr double kSteepest = 1.56;
    const double pitch = std::asin(std::clamp(offset.z / length, -1.0, 1.0));
    const double wanted = std::clamp(pitch + pitchRadians, -kSteepest, kSteepest);
    Vec2 level(offset.x, offset.y);
    if (glm::length(level) < 1e-9 * length)
        level = Vec2(0, offset.z > 0 ? -1 : 1);
    level = glm::normalize(level) * std::cos(wanted) * length;
    eye = target + Vec3(level.x, level.y, std::sin(wanted) * length);
}

void Camera::pan(double rightUnits, double upUnits)
{
    const Vec3 shift = right() * rightUnits + upward() * upUnits;
    eye += shift;
    target += shift;
}

void Camera::zoomAt(double factor, const Vec2& cursorFromCentre)
{
    // As close as double can still tell the eye from the target.
    const double closest = 1e-9 * std::max(glm::length(target), 1e-20);
    if (!(distance() * factor > closest))
        return;
    const Vec3 cursor = target + right() * cursorFromCentre.x + upward() * cursorFromCentre.y;
    eye = cursor + (eye - cursor) * factor;
    target = cursor + (target - cursor) * factor;
}

const std::vector<std::string>& namedViews()
{
    static const std::vector<std::string> views = {"iso", "front", "back", "left", "right", "top", "bottom"};
    return views;
}

std::optional<Camera> namedView(std::string_view name, const std::vector<Vec3>& points, double aspect,
                                bool orthographic, double verticalFovDegrees)
{
    // The direction in which each view looks.
    constexpr double k = 0.57735026918962576;
    static const std::array<Vec3, 7> kDirections = {Vec3(-k, k, -k), Vec3(0, 1, 0),  Vec3(0, -1, 0),
                                                    Vec3(1, 0, 0),   Vec3(-1, 0, 0), Vec3(0, 0, -1),
                                                    Vec3(0, 0, 1)};
    const auto found = std::find(namedViews().begin(), namedViews().end(), name);
    if (found == namedViews().end())
        return std::nullopt;
    const Vec3 direction = kDirections[static_cast<size_t>(found - namedViews().begin())];
    Camera camera;
    camera.orthographic = orthographic;
    camera.verticalFovDegrees = verticalFovDegrees;
    camera.up = direction.z == 1.0 ? Vec3(0, -1, 0) : direction.z == -1.0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    camera.target = Vec3(0);
    camera.eye = -direction;
    return fitted(camera, points, aspect);
}

Camera fitted(Camera camera, const std::vector<Vec3>& points, double aspect)
{
    if (points.empty())
        return fitted(camera, {Vec3(-1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1), Vec3(1)}, aspect);
    const Vec3 forward = camera.forward();
    Box box;
    for (const Vec3& point : points)
        box.add(point);
    const Vec3 centre = box.centre();

    // Each side of the view is a plane through the eye. For each pair of sides the points that reach furthest
    // towards them say how far back the eye must be, and where between them.
    const double tangentY = std::tan(glm::radians(camera.verticalFovDegrees) * 0.5);
    double distance = 0.0;
    Vec3 aside(0);
    for (const auto& [axis, tangent] :
         {std::pair(camera.right(), tangentY * aspect), std::pair(camera.upward(), tangentY)}) {
        double highest = -std::numeric_limits<double>::infinity();
        double lowest = highest;
        for (const Vec3& point : points) {
            const double across = glm::dot(point - centre, axis);
            const double nearer = camera.orthographic ? 0.0 : -tangent * glm::dot(point - centre, forward);
            highest = std::max(highest, across + nearer);
            lowest = std::max(lowest, nearer - across);
        }
        distance = std::max(distance, (highest + lowest) / (2.0 * tangent));
        aside += axis * ((highest - lowest) * 0.5);
    }
    constexpr double kMargin = 1.06;
    if (!(distance > 0.0))
        distance = 1.0;  // a scene of a single point
    camera.target = centre + aside;
    camera.eye = camera.target - forward * (distance * kMargin);
    return camera;
}

}  // namespace knotspan
