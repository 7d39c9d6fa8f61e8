#include "ui/tools/trim_sight.h"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

namespace knotspan {

namespace {

constexpr double kCoarsest = 1e-4;  // of the surface's size: no curve is further off
constexpr double kFinest = 1e-7;    // nor finer than that
constexpr double kRounding = 1e-12;

}  // namespace

Sight sightOf(const Camera& camera, int width, int height)
{
    const Vec2 middle(0.5 * width, 0.5 * height);
    const double scale = 0.5 * height / std::tan(glm::radians(camera.verticalFovDegrees) * 0.5);
    // Times depth.
    Mat4 fromView(0.0);
    fromView[0][0] = scale;
    fromView[1][1] = -scale;
    if (camera.orthographic) {
        const double depth = camera.distance();
        fromView[3] = Vec4(middle.x * depth, middle.y * depth, 0, depth);
    } else {
        fromView[2] = Vec4(-middle.x, -middle.y, 0, -1);
    }
    Mat4 fromEye(1.0);
    fromEye[3] = Vec4(-camera.eye, 1);
    return {fromView * camera.rotation() * fromEye,
            camera.orthographic ? Vec4(-camera.forward(), 0) : Vec4(camera.eye, 1)};
}

double trimTolerance(const ToolSettings& settings, const SceneObject& object)
{
    const double size = object.bounds().diagonal();
    return std::clamp(settings.friends.gap, kFinest * size, kCoarsest * size);
}

QString nearnessText(double error, const SceneObject& object, const std::string& units)
{
    if (error <= kRounding * object.bounds().diagonal())
        return QObject::tr("exactly");
    return QObject::tr("to within %1 %2").arg(QString::number(error, 'g', 2), QString::fromStdString(units));
}

}  // namespace knotspan
