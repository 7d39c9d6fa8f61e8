#include "tests/random_surface.h"

#include <cmath>

namespace knotspan::testing {

namespace {

KnotVector randomKnots(std::mt19937& random, int degree, int spans, double spanRatio)
{
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> knots(static_cast<size_t>(degree) + 1, -0.5);
    double at = -0.5;
    for (int span = 1; span < spans; ++span) {
        at += std::pow(spanRatio, unit(random));
        const int multiplicity = unit(random) < 0.25 ? 1 + static_cast<int>(unit(random) * degree) : 1;
        knots.insert(knots.end(), static_cast<size_t>(multiplicity), at);
    }
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, at + std::pow(spanRatio, unit(random)));
    return KnotVector::create(degree, std::move(knots)).value();
}

}  // namespace

NurbsSurface randomSurface(std::mt19937& random, const RandomSurfaceShape& shape)
{
    KnotVector u = randomKnots(random, shape.degreeU, shape.spans, shape.spanRatio);
    KnotVector v = randomKnots(random, shape.degreeV, shape.spans, shape.spanRatio);
    std::uniform_real_distribution<double> jitter(-0.4, 0.4);
    std::uniform_real_distribution<double> logWeight(std::log(0.2), std::log(5.0));
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
