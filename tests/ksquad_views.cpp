#include "tests/ksquad_views.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/random_surface.h"

namespace knotspan::testing {

RandomView randomView(std::mt19937& random, const Box& box, const Vec3& origin, bool close, bool orthographic)
{
    const double size = box.diagonal();
    Vec3 direction(0);
    while (!(glm::length(direction) > 0.1))
        direction = {randomBetween(random, -1, 1), randomBetween(random, -1, 1),
                     randomBetween(random, -1, 1)};
    direction = glm::normalize(direction);
    const Vec3 somewhere =
        box.low + box.size() * Vec3(randomBetween(random, 0, 1), randomBetween(random, 0, 1),
                                    randomBetween(random, 0, 1));
    const double distance = size * (close ? randomBetween(random, 0.02, 0.5) : randomBetween(random, 0.7, 3));
    const Vec3 eye = (close ? somewhere : box.centre()) - direction * distance;

    const Vec3 aside = std::abs(direction.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    const Vec3 right = glm::normalize(glm::cross(direction, aside));
    const Vec3 up = glm::cross(right, direction);
    Mat4 rotation(1.0);
    for (int axis = 0; axis < 3; ++axis)
        rotation[axis] = Vec4(right[axis], up[axis], -direction[axis], 0);
    Mat4 moved(1.0);
    moved[3] = Vec4(origin - eye, 1);

    constexpr double kWidth = 1920;
    constexpr double kHeight = 1080;
    const double tangent = std::tan(glm::radians(35.0) * 0.5);
    Mat4 projection(0.0);
    if (orthographic) {
        const double half = distance * tangent;
        projection[0][0] = kHeight / kWidth / half;
        projection[1][1] = -1 / half;
        projection[2][2] = 1 / (8 * size);
        projection[3][2] = 0.5;
        projection[3][3] = 1;
    } else {
        projection[0][0] = kHeight / kWidth / tangent;
        projection[1][1] = -1 / tangent;
        projection[2][3] = -1;
        projection[3][2] = distance * (close ? std::pow(10, randomBetween(random, -4, -0.3)) : 1e-4);
    }
    RandomView result;
    result.toClip = projection * rotation * moved;
    result.view = screenView(result.toClip, kWidth, kHeight);
    return result;
}

std::vector<PlacedKsQuad> ksQuadsOf(const Scene& scene)
{
    std::vector<PlacedKsQuad> result;
    for (const auto& [id, object] : scene.objects())
        for (size_t number = 0; number < ksQuadCount(object->surface); ++number)
            result.push_back({&object->surface, object->transform, number});
    return result;
}

PlacedKsQuad randomKsQuad(std::mt19937& random, const NurbsSurface& surface)
{
    return {&surface, Mat4(1.0), random() % ksQuadCount(surface)};
}

SeenKsQuad seenIn(const RandomView& random, const PlacedKsQuad& placed)
{
    const NurbsSurface& surface = *placed.surface;
    const Vec3 origin = surface.bounds().centre();
    Mat4 shift(1.0);
    shift[3] = Vec4(origin, 1);
    const ScreenView view = screenView(random.toClip * placed.transform * shift, 1920, 1080);
    const BezierNet net = BezierConversion(surface, origin).net(ksQuads(surface)[placed.number]);
    return {&surface, placed.number, transformed(net, view.toPixels), view};
}

RandomView viewFromAmong(std::mt19937& random, const PlacedKsQuad& placed)
{
    const BezierNet net = BezierConversion(*placed.surface).net(ksQuads(*placed.surface)[placed.number]);
    Box around;
    for (const Vec4& point : net.points)
        around.add(transformed(Vec3(point) / point.w, placed.transform));
    return randomView(random, around, Vec3(0), true, false);
}

}  // namespace knotspan::testing
