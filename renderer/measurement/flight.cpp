#include "renderer/measurement/flight.h"

#include <cmath>

#include "renderer/scene/framed_points.h"

namespace knotspan {

std::vector<Camera> flightAround(const Scene& scene, size_t count, double aspect)
{
    constexpr double kTurn = 6.283185307179586;
    constexpr double kClimb = 0.5;  // radians, from the first view's height
    constexpr double kClosest = 4;  // times as close as where all of it shows
    const std::vector<Vec3> points = framedPoints(scene);
    std::vector<Camera> views;
    if (points.empty())
        return views;
    for (size_t k = 0; k < count; ++k) {
        const double way = kTurn * static_cast<double>(k) / static_cast<double>(count);
        Camera camera = *namedView("iso", points, aspect, false);
        camera.orbit(way, -kClimb * std::sin(2 * way));
        camera.zoomAt(std::pow(kClosest, (std::cos(2 * way) - 1) / 2), {0, 0});
        views.push_back(camera);
    }
    return views;
}

}  // namespace knotspan
