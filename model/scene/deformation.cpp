#include "model/scene/deformation.h"

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "model/core/check.h"

namespace knotspan {
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

SharedObject withWave(const SceneObject& object, const Wave& wave)
{
    std::vector<ControlPoint> points = object.surface.controlPoints();
    for (ControlPoint& point : points)
        point.position += alongZ(object, wave.distanceAt(transformed(point.position, object.transform)));
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

double Wave::distanceAt(const Vec3& place) const
{
    const double phase = phasePerUnit * (place.x + place.y) - phaseAtZero;
    return amplitude * (std::sin(phase + time) - std::sin(phase));
}

std::optional<Wave> waveAt(const Scene& rest, Deformation deformation, int frame)
{
    const Box bounds = rest.bounds();
    const double size = bounds.diagonal();
    if (deformation != Deformation::all || frame == 0 || size == 0)
        return std::nullopt;
    const double perUnit = 2 * M_PI * kWavesAcross / size;
    return Wave{kAmplitude * size, perUnit, perUnit * (bounds.low.x + bounds.low.y),
                2 * M_PI * frame / kFramesPerWave};
}

Scene deformed(const Scene& rest, Deformation deformation, int frame)
{
    Scene scene = rest;
    if (const auto wave = waveAt(rest, deformation, frame)) {
        for (const auto& [id, object] : rest.objects())
            if (object->visible)
                scene.exchange(id, withWave(*object, *wave));
        return scene;
    }
    const double size = rest.bounds().diagonal();
    if (deformation != Deformation::point || frame == 0 || size == 0)
        return scene;
    for (const auto& [id, object] : rest.objects()) {
        if (!object->visible)
            continue;
        scene.exchange(
            id, withMovedMiddle(*object, kAmplitude * size * std::sin(2 * M_PI * frame / kFramesPerWave)));
        break;
    }
    return scene;
}

DeformedScene deformedFor(bool wavesOnDevice, const Scene& rest, Deformation deformation, int frame)
{
    const auto wave = waveAt(rest, deformation, frame);
    if (wavesOnDevice && wave)
        return {rest, wave, Joins::anew};
    return {deformed(rest, deformation, frame), std::nullopt, wave ? Joins::kept : Joins::anew};
}

}  // namespace knotspan
