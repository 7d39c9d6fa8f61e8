#include <cmath>

#include "model/samples/net.h"
#include "model/samples/samples.h"

namespace knotspan {

namespace {

const Vec3 kFarAway{1e6, 1e6, 1e6};

// Clamped, `spans` spans, each longer than the one before, the last 10^orders times the first.
KnotVector gradedKnots(int degree, int spans, double orders)
{
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
    double end = 0;
    for (int k = 0; k < spans; ++k) {
        end += std::pow(10.0, orders * k / (spans - 1));
        knots.insert(knots.end(), k + 1 < spans ? 1 : static_cast<size_t>(degree) + 1, end);
    }
    auto result = KnotVector::create(degree, std::move(knots));
    check(result.has_value(), "graded knots are valid");
    return *std::move(result);
}

// From 0 at the first of `count` control points to 1 at the last.
double part(int index, int count)
{
    return static_cast<double>(index) / (count - 1);
}

// 10 x 10 units of a low hill: control points stand evenly, however uneven the knots.
Vec3 hill(double a, double b)
{
    return {10 * a - 5, 10 * b - 5, 1.6 * std::sin(3 * a) * std::sin(3 * b)};
}

SceneObject gradedBoth()
{
    const KnotVector knotsU = gradedKnots(9, 13, 6.5);
    const KnotVector knotsV = clampedIntegerKnots(9, 4);
    const int countU = knotsU.controlPointCount();
    const int countV = knotsV.controlPointCount();
    auto surface = surfaceOf(knotsU, knotsV, [&](int i, int j) -> ControlPoint {
        return {kFarAway + hill(part(i, countU), part(j, countV)), std::pow(10.0, 8.2 * part(i, countU) - 4)};
    });
    return namedObject("Degree 9, spans over six orders, weights over eight", colourOf(40, 0.5, 0.9),
                       std::move(surface));
}

// Not clamped, so its border lies inside the net.
SceneObject unclamped()
{
    const KnotVector knotsU = uniformKnots(7, 20, 1000);
    const KnotVector knotsV = gradedKnots(2, 9, 3);
    const int countU = knotsU.controlPointCount();
    const int countV = knotsV.controlPointCount();
    auto surface = surfaceOf(knotsU, knotsV, [&](int i, int j) -> ControlPoint {
        const Vec3 place = hill(part(i, countU), part(j, countV));
        return {kFarAway + Vec3(12, 0, 0) + place, std::pow(10.0, 4 * part(j, countV) - 2)};
    });
    return namedObject("Degree 7 x 2, not clamped", colourOf(200, 0.45, 0.85), std::move(surface));
}

SceneObject ruled()
{
    const KnotVector knotsU = KnotVector::clampedUniform(1, 1);
    const KnotVector knotsV = gradedKnots(9, 10, 6);
    const int countV = knotsV.controlPointCount();
    auto surface = surfaceOf(knotsU, knotsV, [&](int i, int j) -> ControlPoint {
        const double across = part(j, countV);
        return {kFarAway + Vec3(20 * i - 3, 6.5, 2.2 * std::sin(2.5 * across) * (1 - 0.4 * i) - 0.5) +
                    Vec3(0, 4 * across, 0),
                std::pow(10.0, 6 * across - 3)};
    });
    return namedObject("Degree 1 x 9", colourOf(330, 0.4, 0.85), std::move(surface));
}

}  // namespace

Scene makeExtremes()
{
    Scene scene;
    scene.add(gradedBoth());
    scene.add(unclamped());
    scene.add(ruled());
    return scene;
}

}  // namespace knotspan
