#include "tests/facing_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "model/geometry/evaluation.h"
#include "tests/random_surface.h"

namespace knotspan::testing {

namespace {

// The span's own end belongs to the next one.
double parameterAt(const KnotVector& knots, int span, double t)
{
    return std::min(knots[span] + (knots[span + 1] - knots[span]) * t,
                    std::nextafter(knots[span + 1], knots[span]));
}

bool isDirection(std::mt19937& random)
{
    return random() % 4 == 0;
}

}  // namespace

FacingSamples::FacingSamples(const NurbsSurface& surface, const KsQuad& quad, int cells)
{
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const SurfacePoint point =
                evaluate(surface, parameterAt(surface.knotsU(), quad.spanU, double(i) / cells),
                         parameterAt(surface.knotsV(), quad.spanV, double(j) / cells));
            samples_.push_back({point.position, glm::cross(point.du, point.dv)});
            longest_ = std::max(longest_, glm::length(samples_.back().normal));
        }
}

bool FacingSamples::showTo(const Vec4& eye) const
{
    constexpr double kRounding = 1e-12;
    return std::any_of(samples_.begin(), samples_.end(), [&](const Sample& sample) {
        const Vec3 towards = Vec3(eye) - eye.w * sample.position;
        return glm::dot(sample.normal, towards) > kRounding * longest_ * glm::length(towards);
    });
}

Vec4 FacingSamples::randomEye(std::mt19937& random, const Box& box) const
{
    const Vec3 direction = randomDirection(random);
    if (isDirection(random))
        return {direction, 0};
    return {box.centre() + direction * box.diagonal() * randomBetween(random, 0.7, 3), 1};
}

Vec4 FacingSamples::tangentEye(std::mt19937& random, const Box& box) const
{
    const Sample& sample = samples_[random() % samples_.size()];
    const double length = glm::length(sample.normal);
    if (!(length > 0))
        return randomEye(random, box);
    const Vec3 normal = sample.normal / length;
    const Vec3 aside = randomDirection(random);
    const double tilt = std::pow(10.0, randomBetween(random, -7, -0.5)) * (random() % 2 == 0 ? 1 : -1);
    const Vec3 along = aside - glm::dot(aside, normal) * normal + tilt * normal;
    if (isDirection(random))
        return {along, 0};
    return {sample.position + along * box.diagonal() * std::pow(10.0, randomBetween(random, -3, 2)), 1};
}

Vec3 randomDirection(std::mt19937& random)
{
    for (;;) {
        const Vec3 v(randomBetween(random, -1, 1), randomBetween(random, -1, 1),
                     randomBetween(random, -1, 1));
        const double length = glm::length(v);
        if (length > 0.1 && length < 1)
            return v / length;
    }
}

NurbsSurface bumpyBall(std::mt19937& random, int spans, double bumps, bool rational)
{
    std::vector<double> numbers(4, 0.0);
    for (int k = 1; k < spans; ++k)
        numbers.push_back(k);
    numbers.insert(numbers.end(), 4, spans);
    const KnotVector knots = KnotVector::create(3, std::move(numbers)).value();
    std::vector<ControlPoint> points;
    for (int i = 0; i < spans + 3; ++i)
        for (int j = 0; j < spans + 3; ++j) {
            const double east = glm::two_pi<double>() * i / (spans + 2);
            const double north = glm::pi<double>() * ((j + 0.5) / (spans + 3) - 0.5);
            const double radius = 1 + bumps * randomBetween(random, -1, 1);
            points.push_back({radius * Vec3(std::cos(east) * std::cos(north),
                                            std::sin(east) * std::cos(north), std::sin(north)),
                              rational ? std::exp(randomBetween(random, -0.7, 0.7)) : 1.0});
        }
    return NurbsSurface::create(knots, knots, std::move(points)).value();
}

int soakOf(int views)
{
    return std::getenv("KNOTSPAN_SOAK") != nullptr ? 10 * views : views;
}

}  // namespace knotspan::testing
