#include "ui/viewport/navigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace knotspan
