#include "model/samples/net.h"

#include <algorithm>
#include <cmath>

namespace knotspan {

namespace {

KnotVector valid(int degree, std::vector<double> knots)
{
    auto result = KnotVector::create(degree, std::move(knots));
    check(result.has_value(), "a sample's knots are valid");
    return *std::move(result);
}

}  // namespace

KnotVector uniformKnots(int degree, int controlPoints, double first)
{
    std::vector<double> knots;
    for (int i = 0; i < controlPoints + degree + 1; ++i)
        knots.push_back(first + i);
    return valid(degree, std::move(knots));
}

KnotVector clampedIntegerKnots(int degree, int spans)
{
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
    for (int i = 1; i < spans; ++i)
        knots.push_back(i);
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, spans);
    return valid(degree, std::move(knots));
}

double grevilleAbscissa(const KnotVector& knots, int i)
{
    double sum = 0;
    for (int k = 1; k <= knots.degree(); ++k)
        sum += knots[i + k];
    return sum / knots.degree();
}

Colour colourOf(double hue, double saturation, double value)
{
    const auto part = [&](double offset) {
        const double sector = std::fmod(offset + hue / 60.0 + 6.0, 6.0);
        return value - value * saturation * std::clamp(std::min(sector, 4.0 - sector), 0.0, 1.0);
    };
    return {part(5), part(3), part(1)};
}

SceneObject namedObject(std::string name, const Colour& colour, NurbsSurface surface)
{
    return {std::move(name), colour, Mat4(1.0), true, std::move(surface), {}};
}

}  // namespace knotspan
