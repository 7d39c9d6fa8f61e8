#include "app/deformation.h"

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/core/check.h"

namespace knotspan::app {
namespace {

constexpr double kAmplitude = 0.01;  // of the model's size
constexpr int kFramesPerWave = 64;
constexpr double kWavesAcross = 3;

SharedObject withControlPoints(const SceneObject& object, std::vector<ControlPoint> points)
{
    auto surface = NurbsSurface::create(object.surface.knotsU(), object.surface.knotsV(), std::move(points));
    check(surface.has_value(), "a small wave leaves a surface a surface");
    SceneObject moved = object;
    moved.surface = std::move(*surface);
    return std::make_shared<const SceneObject>(std::move(moved));
}

// A move along the model's z, in the object's own space.
Vec3 alongZ(const SceneObject& object, double distance)
{
    return glm::inverse(glm::dmat3(object.transform)) * Vec3(0, 0, distance);
}

SharedObject withMovedMiddle(const SceneObject& object, double distance)
{
    std::vector<ControlPoint> points = object.surface.controlPoints();
    const int i = object.surface.countU() / 2;
    const int j = object.surface.countV() / 2;
    points[static_cast<size_t>(i * object.surface.countV() + j)].position += alongZ(object, distance);
    return withControlPoints(object, std::move(points));
}

SharedObject withWave(const SceneObject& object, const Box& bounds, double time)
{
    const double size = bounds.diagonal();
    std::vector<ControlPoint> points = object.surface.controlPoints();
    for (ControlPoint& point : points) {
        const Vec3 place = transformed(point.position, object.transform) - bounds.low;
        const double phase = 2 * M_PI * kWavesAcross * (place.x + place.y) / size;
        const double distance = kAmplitude * size * (std::sin(phase + time) - std::sin(phase));
        point.position += alongZ(object, distance);
    }
    return withControlPoints(object, std::move(points));
}

}  // namespace

const std::vector<std::string>& deformationNames()
{
    static const std::vector<std::string> names{"none", "point", "all"};
    return names;
}

std::optional<Deformation> findDeformation(const std::string& name)
{
    const auto& names = deformationNames();
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        return {};
    return static_cast<Deformation>(found - names.begin());
}

Scene deformed(const Scene& rest, Deformation deformation, int frame)
{
    Scene scene = rest;
    const Box bounds = rest.bounds();
    if (deformation == Deformation::none || frame == 0 || bounds.diagonal() == 0)
        return scene;
    const double time = 2 * M_PI * frame / kFramesPerWave;
    for (const auto& [id, object] : rest.objects()) {
        if (!object->visible)
            continue;
        if (deformation == Deformation::all) {
            scene.exchange(id, withWave(*object, bounds, time));
            continue;
        }
        scene.exchange(id, withMovedMiddle(*object, kAmplitude * bounds.diagonal() * std::sin(time)));
        break;
    }
    return scene;
}

}  // namespace knotspan::app
