#include "tests/random_surface.h"

#include <cmath>

namespace knotspan::testing {

double randomBetween(std::mt19937& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

KnotVector randomKnots(std::mt19937& random, int degree, int spans, double spanRatio, bool clamped)
{
    const auto length = [&] { return std::pow(spanRatio, randomBetween(random, 0, 1)); };
    std::vector<double> knots{-0.5};
    const auto addEnd = [&] {
        for (int k = 0; k < degree; ++k)
            knots.push_back(knots.back() + (clamped ? 0 : length()));
    };
    addEnd();
    for (int span = 1; span < spans; ++span) {
        const double at = knots.back() + length();
        const bool several = randomBetween(random, 0, 1) < 0.25;
        const int multiplicity = several ? 1 + static_cast<int>(randomBetween(random, 0, 1) * degree) : 1;
        knots.insert(knots.end(), static_cast<size_t>(multiplicity), at);
    }
    knots.push_back(knots.back() + length());
    addEnd();
    return KnotVector::create(degree, std::move(knots)).value();
}

NurbsSurface randomSurface(std::mt19937& random, const RandomSurfaceShape& shape)
{
    KnotVector u = randomKnots(random, shape.degreeU, shape.spans, shape.spanRatio, shape.clamped);
    KnotVector v = randomKnots(random, shape.degreeV, shape.spans, shape.spanRatio, shape.clamped);
    std::uniform_real_distribution<double> jitter(-0.4, 0.4);
    std::uniform_real_distribution<double> logWeight(-std::log(shape.weightRatio),
                                                     std::log(shape.weightRatio));
    std::vector<ControlPoint> points;
    for (int i = 0; i < u.controlPointCount(); ++i)
        for (int j = 0; j < v.controlPointCount(); ++j)
            points.push_back(
                {Vec3(i + jitter(random), j + jitter(random), 2.0 * jitter(random)) + shape.offset,
                 shape.rational ? std::exp(logWeight(random)) : 1.0});
    return NurbsSurface::create(std::move(u), std::move(v), std::move(points)).value();
}

Scene sceneOf(NurbsSurface surface, const std::string& name)
{
    Scene scene;
    scene.add(SceneObject{.name = name, .surface = std::move(surface)});
    return scene;
}

}  // namespace knotspan::testing
