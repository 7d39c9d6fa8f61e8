#include "model/geometry/loop_direction.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/core/check.h"

namespace knotspan {
namespace {

constexpr double kWidestGap = 5e-3;  // of the loop's size
constexpr double kNothing = 1e-12;   // of its size's square

std::vector<Vec2> polygonOf(const std::vector<TrimCurve>& curves)
{
    std::vector<Vec2> polygon;
    for (const TrimCurve& curve : curves) {
        const KnotVector& knots = curve.knots();
        // Few a span where there are many: a small file may use a long curve again and again.
        const int samples =
            knots.degree() == 1 ? 1 : std::clamp(256 / static_cast<int>(knots.spans().size()), 1, 16);
        for (const int span : knots.spans())
            for (int k = 0; k < samples; ++k)
                polygon.push_back(
                    curve.evaluate(knots[span] + (knots[span + 1] - knots[span]) * k / samples));
    }
    return polygon;
}

TrimCurve reversed(const TrimCurve& curve)
{
    std::vector<double> values(curve.knots().values().rbegin(), curve.knots().values().rend());
    for (double& value : values)
        value = 0.0 - value;
    auto knots = KnotVector::create(curve.knots().degree(), std::move(values));
    check(knots.has_value(), "knots turned round are valid");
    auto result = TrimCurve::create(*std::move(knots), {curve.points().rbegin(), curve.points().rend()});
    check(result.has_value(), "points in the other order are valid");
    return *std::move(result);
}

}  // namespace

double signedArea(const std::vector<Vec2>& polygon)
{
    double area = 0;
    for (size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 a = polygon[k] - polygon[0];
        const Vec2 b = polygon[(k + 1) % polygon.size()] - polygon[0];
        area += (a.x * b.y - a.y * b.x) / 2;
    }
    return area;
}

double signedArea(const std::vector<TrimCurve>& curves)
{
    return signedArea(polygonOf(curves));
}

std::vector<TrimCurve> turnedRound(const std::vector<TrimCurve>& curves)
{
    std::vector<TrimCurve> turned;
    turned.reserve(curves.size());
    for (auto it = curves.rbegin(); it != curves.rend(); ++it)
        turned.push_back(reversed(*it));
    return turned;
}

TrimLoop oriented(TrimLoop loop)
{
    const std::vector<Vec2> polygon = polygonOf(loop.curves);
    if (polygon.empty())
        return loop;
    Vec2 low = polygon[0];
    Vec2 high = polygon[0];
    for (const Vec2& place : polygon) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const double size = glm::length(high - low);
    const TrimCurve& last = loop.curves.back();
    const double gap = glm::distance(last.evaluate(last.knots().domainEnd()), polygon[0]);
    const double area = signedArea(polygon);
    if (!(gap <= kWidestGap * size && std::abs(area) > kNothing * size * size) || (area > 0) == loop.outer)
        return loop;
    // Curves that jump, or of huge numbers, may seem to run the wrong way both times: those stay.
    std::vector<TrimCurve> turned = turnedRound(loop.curves);
    if ((signedArea(turned) > 0) == loop.outer)
        loop.curves = std::move(turned);
    return loop;
}

}  // namespace knotspan
