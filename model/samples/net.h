// What every sample is built with: nets of control points from a formula, colours, objects.
#pragma once

#include <string>
#include <vector>

#include "model/core/check.h"
#include "model/scene/scene.h"

namespace knotspan {

// The surface whose control point (i, j) is at(i, j).
template <class At>
[[nodiscard]] NurbsSurface surfaceOf(const KnotVector& knotsU, const KnotVector& knotsV, const At& at)
{
    std::vector<ControlPoint> points;
    for (int i = 0; i < knotsU.controlPointCount(); ++i)
        for (int j = 0; j < knotsV.controlPointCount(); ++j)
            points.push_back(at(i, j));
    auto result = NurbsSurface::create(knotsU, knotsV, std::move(points));
    check(result.has_value(), "a sample's surface is valid");
    return *std::move(result);
}

// Knots first, first + 1, ..., each once: not clamped; the domain runs from first + degree on.
[[nodiscard]] KnotVector uniformKnots(int degree, int controlPoints, double first);

// 0, 1, ..., spans, the ends degree + 1 times.
[[nodiscard]] KnotVector clampedIntegerKnots(int degree, int spans);

// The parameter at which control point i weighs most: the mean of the degree knots after it.
[[nodiscard]] double grevilleAbscissa(const KnotVector& knots, int i);

// Hue in degrees, saturation and value 0 to 1.
[[nodiscard]] Colour colourOf(double hue, double saturation, double value);

[[nodiscard]] SceneObject namedObject(std::string name, const Colour& colour, NurbsSurface surface);

}  // namespace knotspan
