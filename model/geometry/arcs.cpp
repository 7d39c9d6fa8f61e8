#include "model/geometry/arcs.h"

#include <array>
#include <cmath>

#include "model/core/check.h"

namespace knotspan {

namespace {

constexpr double kPi = 3.14159265358979323846;

// The middle point of an arc stands where its end tangents meet and weighs the cosine of half the arc's
// angle. Mirror images are equal to the bit.
const std::array<ArcPoint, 17>& circle()
{
    static const std::array<ArcPoint, 17> points = [] {
        const double t = std::sqrt(2.0) - 1;  // tan 22.5 degrees
        const double c = 1 / std::sqrt(1 + t * t);
        const double h = std::sqrt(0.5);
        return std::array<ArcPoint, 17>{{{1, 0, 1},
                                         {1, t, c},
                                         {h, h, 1},
                                         {t, 1, c},
                                         {0, 1, 1},
                                         {-t, 1, c},
                                         {-h, h, 1},
                                         {-1, t, c},
                                         {-1, 0, 1},
                                         {-1, -t, c},
                                         {-h, -h, 1},
                                         {-t, -1, c},
                                         {0, -1, 1},
                                         {t, -1, c},
                                         {h, -h, 1},
                                         {1, -t, c},
                                         {1, 0, 1}}};
    }();
    return points;
}

std::vector<ArcPoint> equalPieces(double degrees, int pieces)
{
    const double half = degrees / pieces / 2 * kPi / 180;
    const double weight = std::cos(half);
    std::vector<ArcPoint> points{{1, 0, 1}};
    for (int k = 1; k <= 2 * pieces; ++k) {
        const bool middle = k % 2 == 1;
        const double radius = middle ? 1 / weight : 1;
        points.push_back({radius * std::cos(k * half), radius * std::sin(k * half), middle ? weight : 1});
    }
    return points;
}

}  // namespace

std::vector<ArcPoint> arcPoints(double degrees)
{
    const double angle = std::abs(degrees);
    check(angle > 0 && angle <= 360, "an arc has a length, and is no more than a circle");
    const int pieces = static_cast<int>(std::ceil(angle / 45));
    std::vector<ArcPoint> points = angle == 45.0 * pieces
                                       ? std::vector(circle().begin(), circle().begin() + 2 * pieces + 1)
                                       : equalPieces(angle, pieces);
    if (degrees < 0)
        for (ArcPoint& point : points)
            point.y = 0.0 - point.y;
    return points;
}

KnotVector arcKnots(int pieces)
{
    std::vector<double> knots{0, 0, 0};
    for (int i = 1; i < pieces; ++i)
        knots.insert(knots.end(), 2, i);
    knots.insert(knots.end(), 3, pieces);
    auto result = KnotVector::create(2, std::move(knots));
    check(result.has_value(), "the knots of arcs are valid");
    return *std::move(result);
}

}  // namespace knotspan
