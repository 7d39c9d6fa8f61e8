#include "tests/pixels/error_measurement.h"

#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "renderer/leak_count.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

bool isWholeSweep()
{
    return std::getenv("KNOTSPAN_SWEEP") != nullptr;
}

int sweepViews(int few)
{
    const char* wanted = std::getenv("KNOTSPAN_SWEEP");
    return wanted != nullptr ? std::max(1, std::atoi(wanted)) : few;
}

Camera randomCamera(std::mt19937& random, const Box& box, double nearest)
{
    Vec3 direction(0);
    while (!(glm::length(direction) > 0.1))
        direction = {randomBetween(random, -1, 1), randomBetween(random, -1, 1),
                     randomBetween(random, -1, 1)};
    Camera camera;
    camera.orthographic = randomBetween(random, 0, 1) < 0.25;
    camera.up = {0, 0, 1};
    const double middle = randomBetween(random, 0, 0.4);
    for (int axis = 0; axis < 3; ++axis)
        camera.target[axis] = box.centre()[axis] + middle * box.size()[axis] * randomBetween(random, -1, 1);
    const double distance = box.diagonal() * std::pow(10.0, randomBetween(random, std::log10(nearest), 0.4));
    camera.eye = camera.target - glm::normalize(direction) * distance;
    return camera;
}

std::vector<PathInfo> boundPaths(Renderer& renderer)
{
    std::vector<PathInfo> list;
    for (const PathInfo& path : paths()) {
        if (path.keepsTolerance() && renderer.whyUnavailable(path.id).empty())
            list.push_back(path);
    }
    return list;
}

std::uint64_t leaks(Renderer& renderer, const Scene& scene, const Frame& frame, double errorPx)
{
    const auto shown = renderer.captureKsQuads();
    if (!shown) {
        ADD_FAILURE() << shown.error().sentence();
        return 0;
    }
    return countLeaks(scene, frame, *shown, errorPx);
}

}  // namespace knotspan::testing
