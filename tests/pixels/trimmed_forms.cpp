#include "tests/pixels/trimmed_forms.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/geometry/primitives.h"
#include "tests/model/trimming/loop_samples.h"

namespace knotspan::testing {

namespace {

std::vector<double> halves(int count)
{
    std::vector<double> places;
    for (int k = 0; k <= count; ++k)
        places.push_back(0.5 * k);
    return places;
}

// The place along an arc from angle 0 to 45 degrees with the middle weight cos 22.5, at that angle.
double alongArc(double angle)
{
    double low = 0;
    double high = 1;
    const double weight = std::cos(M_PI / 8);
    for (int k = 0; k < 50; ++k) {
        const double t = 0.5 * (low + high);
        // The control points lie at (1, 0), (1, tan 22.5), (cos 45, sin 45).
        const double b[] = {(1 - t) * (1 - t), 2 * t * (1 - t) * weight, t * t};
        const double x = b[0] + b[1] + b[2] * std::cos(M_PI / 4);
        const double y = b[1] * std::tan(M_PI / 8) + b[2] * std::sin(M_PI / 4);
        (std::atan2(y, x) < angle ? low : high) = t;
    }
    return low;
}

}  // namespace

bool Disc::has(const Vec2& place) const
{
    return glm::length(place - centre) < radius;
}

std::vector<TrimLoop> loopsOf(const Disc& rim, const Disc& hole)
{
    return {{true, {circle(rim.centre, rim.radius)}}, {false, {circle(hole.centre, hole.radius, false)}}};
}

SceneObject platter(std::vector<TrimLoop> loops)
{
    return {.name = "platter", .surface = flatSurface(halves(8), halves(6)), .trimLoops = std::move(loops)};
}

bool onPlatter(const Vec3& place)
{
    const Vec2 at(place);
    return kRim.has(at) && !kHole.has(at);
}

SceneObject pipe()
{
    return {.name = "pipe",
            .surface = cylinder({0, 0, -1}, 1, 2),
            .trimLoops = {{false, {circle(kWindow.centre, kWindow.radius, false)}}}};
}

bool onPipe(const Vec3& place)
{
    double angle = std::atan2(place.y, place.x);
    angle += angle < 0 ? 2 * M_PI : 0;
    const double arc = std::floor(angle / (M_PI / 4));
    return !kWindow.has({arc + alongArc(angle - arc * M_PI / 4), 0.5 * (place.z + 1)});
}

std::vector<Vec3> metOnPlane(const Ray& ray)
{
    const Vec3 at = ray.from - ray.along * (ray.from.z / ray.along.z);
    const bool meets = at.x > 0 && at.x < 4 && at.y > 0 && at.y < 3;
    return meets ? std::vector<Vec3>{at} : std::vector<Vec3>();
}

std::vector<Vec3> metOnPipe(const Ray& ray)
{
    const Vec2 from(ray.from);
    const Vec2 along(ray.along);
    const double a = glm::dot(along, along);
    const double b = glm::dot(from, along);
    const double root = b * b - a * (glm::dot(from, from) - 1);
    std::vector<Vec3> met;
    for (const double sign : {-1.0, 1.0}) {
        const Vec3 at = ray.from + ray.along * ((-b + sign * std::sqrt(std::max(root, 0.0))) / a);
        if (root > 0 && std::abs(at.z) < 1)
            met.push_back(at);
    }
    return met;
}

}  // namespace knotspan::testing
