#include "model/trimming/float_piece.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "shaders/shared/trimming.glsl"

namespace knotspan {

std::uint32_t bitsOf(float number)
{
    std::uint32_t word = 0;
    std::memcpy(&word, &number, sizeof word);
    return word;
}

FloatPiece::FloatPiece(const RegionPiece& piece) : points(piece.points)
{
    const auto degree = static_cast<std::uint32_t>(points.size() - 1);
    const double first = points.front().weight;
    const double factor = std::pow(first / points.back().weight, 1.0 / degree);
    bool rational = false;
    for (size_t k = 0; k <= degree; ++k) {
        TrimPoint& point = points[k];
        // The same curve with another parameter.
        point.weight =
            k == 0 || k == degree ? 1.0 : point.weight / first * std::pow(factor, static_cast<double>(k));
        const auto weight = static_cast<float>(std::clamp(point.weight, 1e-30, 1e30));
        point = {{static_cast<float>(point.position.x), static_cast<float>(point.position.y)}, weight};
        rational = rational || weight != 1.0F;
    }
    words.push_back(degree | (rational ? TRIM_RATIONAL : 0U));
    const auto put = [&](const TrimPoint& point) {
        words.push_back(bitsOf(static_cast<float>(point.position.x)));
        words.push_back(bitsOf(static_cast<float>(point.position.y)));
    };
    put(points.front());
    put(points.back());
    for (size_t k = 1; k < degree; ++k) {
        put(points[k]);
        if (rational)
            words.push_back(bitsOf(static_cast<float>(points[k].weight)));
    }
    const auto [left, right] = std::minmax(points.front().position.x, points.back().position.x);
    const auto [low, high] = std::minmax(points.front().position.y, points.back().position.y);
    lowX = static_cast<float>(left);
    highX = static_cast<float>(right);
    lowY = static_cast<float>(low);
    highY = static_cast<float>(high);
}

std::pair<float, float> FloatPiece::within(float bottom, float top) const
{
    float left = lowX;
    float right = highX;
    const bool leans = (points.front().position.x < points.back().position.x) ==
                       (points.front().position.y < points.back().position.y);
    constexpr float kSlack = 4e-6F;
    if (bottom > lowY)
        (leans ? left : right) = at(bottom) + (leans ? -kSlack : kSlack);
    if (top < highY)
        (leans ? right : left) = at(top) + (leans ? kSlack : -kSlack);
    return {std::max(left, lowX), std::min(right, highX)};
}

float FloatPiece::at(float y) const
{
    if (points.size() == 2) {
        const Vec2 from = points.front().position;
        const Vec2 way = points.back().position - from;
        return static_cast<float>(from.x + (static_cast<double>(y) - from.y) / way.y * way.x);
    }
    const bool rises = points.front().position.y <= points.back().position.y;
    double below = rises ? 0 : 1;
    double above = 1 - below;
    for (int step = 0; step < 30; ++step) {
        const double t = (below + above) / 2;
        (placeOf(points, t).y <= y ? below : above) = t;
    }
    return static_cast<float>(placeOf(points, below).x);
}

}  // namespace knotspan
