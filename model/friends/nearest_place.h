// Where a Bézier curve comes nearest to a point.
#pragma once

#include <vector>

#include "model/friends/edge_strip.h"

namespace knotspan {

// A curve's point and its derivative by t.
struct CurvePoint {
    Vec3 at;
    Vec3 slope;
};
[[nodiscard]] CurvePoint lookAt(const std::vector<Vec4>& curve, double t);

struct NearestPlace {
    double t = 0;
    double distance = 0;
};
// `samples`: the curve's points at t = 0, 1/8, ..., 1.
[[nodiscard]] NearestPlace nearestPlace(const std::vector<Vec4>& curve,
                                        const std::array<Vec3, kEdgeSamples>& samples, const Vec3& point);
// Downhill from there.
[[nodiscard]] NearestPlace nearestFrom(const std::vector<Vec4>& curve, const Vec3& point, double t);

}  // namespace knotspan
