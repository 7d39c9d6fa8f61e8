// Surfaces without pattern, the same in every run.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "model/core/check.h"
#include "model/geometry/nurbs_surface.h"

namespace knotspan::testing {

class RandomSurfaces {
public:
    explicit RandomSurfaces(unsigned seed) : engine_(seed) {}

    [[nodiscard]] double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(engine_);
    }

    // Clamped or not, with spans of up to `orders` orders of length and some interior knots double.
    [[nodiscard]] KnotVector knots(int degree, int controlPoints, bool clamped, double orders = 2)
    {
        std::vector<double> values{between(-3, 3)};
        const int count = controlPoints + degree + 1;
        const auto stays = [&](int i) {
            return clamped && (i <= degree || i > controlPoints) && i != controlPoints;
        };
        for (int i = 1; i < count; ++i) {
            const bool repeated =
                stays(i) || (degree > 1 && between(0, 1) < 0.1 && i != degree + 1 && i < controlPoints &&
                             values.size() > 2 && values[values.size() - 2] != values.back());
            values.push_back(values.back() + (repeated ? 0 : std::pow(10.0, between(-orders, 0))));
        }
        auto result = KnotVector::create(degree, values);
        check(result.has_value(), "the random knots are valid");
        return *result;
    }

    [[nodiscard]] NurbsSurface surface(int degreeU, int degreeV, bool rational, bool clamped = true,
                                       double weightOrders = 1)
    {
        KnotVector knotsU = knots(degreeU, degreeU + 4, clamped);
        KnotVector knotsV = knots(degreeV, degreeV + 3, clamped);
        std::vector<ControlPoint> points(static_cast<size_t>(knotsU.controlPointCount()) *
                                         static_cast<size_t>(knotsV.controlPointCount()));
        for (ControlPoint& point : points)
            point = {{between(-10, 10), between(-10, 10), between(-10, 10)},
                     rational ? std::pow(10.0, between(-weightOrders, weightOrders)) : 1.0};
        auto result = NurbsSurface::create(knotsU, knotsV, points);
        check(result.has_value(), "the random surface is valid");
        return *result;
    }

private:
    std::mt19937 engine_;
};

}  // namespace knotspan::testing
