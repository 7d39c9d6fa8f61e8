#include "model/friends/nearest_place.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/analysis/bezier_curves.h"

namespace knotspan {

CurvePoint lookAt(const std::vector<Vec4>& curve, double t)
{
    std::array<Vec4, kMaxEdgeDegree + 1> points;
    std::copy(curve.begin(), curve.end(), points.begin());
    const size_t degree = curve.size() - 1;
    for (size_t level = degree; level > 1; --level)
        for (size_t k = 0; k < level; ++k)
            points[k] = (1 - t) * points[k] + t * points[k + 1];
    const Vec4 value = (1 - t) * points[0] + t * points[1];
    const Vec4 change = static_cast<double>(degree) * (points[1] - points[0]);
    const Vec3 at = pointOf(value);
    return {at, (Vec3(change) - change.w * at) / value.w};
}

// Gauss-Newton; a step that leads uphill is halved.
NearestPlace nearestFrom(const std::vector<Vec4>& curve, const Vec3& point, double t)
{
    CurvePoint here = lookAt(curve, t);
    double distance = glm::distance(here.at, point);
    for (int step = 0; step < 24; ++step) {
        const double square = glm::dot(here.slope, here.slope);
        if (!(square > 0.0))
            break;
        double change = std::clamp(t - glm::dot(here.at - point, here.slope) / square, 0.0, 1.0) - t;
        bool nearer = false;
        for (int half = 0; half < 6 && std::abs(change) > 1e-15; ++half, change /= 2) {
            const CurvePoint next = lookAt(curve, t + change);
            const double nextDistance = glm::distance(next.at, point);
            if (nextDistance < distance) {
                nearer = true;
                t += change;
                here = next;
                distance = nextDistance;
                break;
            }
        }
        if (!nearer)
            break;
    }
    return {t, distance};
}

NearestPlace nearestPlace(const std::vector<Vec4>& curve, const std::array<Vec3, kEdgeSamples>& samples,
                          const Vec3& point)
{
    std::array<double, kEdgeSamples> distances;
    for (size_t k = 0; k < kEdgeSamples; ++k)
        distances[k] = glm::distance(samples[k], point);
    NearestPlace best{0, std::numeric_limits<double>::infinity()};
    for (size_t k = 0; k < kEdgeSamples; ++k) {
        const bool lowest = (k == 0 || distances[k] <= distances[k - 1]) &&
                            (k + 1 == kEdgeSamples || distances[k] < distances[k + 1]);
        if (!lowest)
            continue;
        const NearestPlace found = nearestFrom(curve, point, static_cast<double>(k) / (kEdgeSamples - 1));
        if (found.distance < best.distance)
            best = found;
    }
    return best;
}

}  // namespace knotspan
