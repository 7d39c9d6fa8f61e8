// Exact values on the KSQuads of an extreme surface, and how far an evaluation is from them, in the units of
// ExtremeBounds.
#pragma once

#include <optional>

#include "tests/model/extremes/extreme_surfaces.h"
#include "tests/model/geometry/precise_evaluation.h"

namespace knotspan::testing {

// A KSQuad by its spans, as ExtremeSurface rows are checked on them: the first, the last, the shortest and
// the longest.
struct SpanPair {
    int u;
    int v;
};
[[nodiscard]] std::vector<SpanPair> tellingKSQuads(const NurbsSurface& surface);

// See ExtremeBounds.
[[nodiscard]] double localSize(const NurbsSurface& surface, SpanPair ksquad, const Vec3& origin);

struct ExactPoint {
    SpanPair ksquad;
    double tu, tv;  // on the KSQuad, in [0, 1]
    double u, v;    // the same place, rounded
    PrecisePoint value;
    // S_u x S_v normalised, or where that is zero its limit on the way to the domain's middle, if there is
    // one.
    std::optional<RealVec3> normal;
    bool isLimit = false;
    // What errors in the derivatives as large as the KSQuad's largest could turn the normal by.
    double normalSensitivity = 0;
};

// With the largest figure of each derivative among the points, and the local size: what errors are measured
// by. That of a second derivative is at least what the first derivatives are per length of the span, since
// only they may be without bend.
struct ExactKSQuad {
    std::vector<ExactPoint> points;
    double size = 0;
    double du = 0, dv = 0, duu = 0, duv = 0, dvv = 0;
};

// Which parameters are exact: t on the span, or the double that t leads to.
enum class Exactly { t, u };
// On the tellingKSQuads(); computed once for each surface of extremeSurfaces().
[[nodiscard]] const std::vector<ExactKSQuad>& exactKSQuads(const ExtremeSurface& row, Exactly exactly);

// The largest component of the error, as a part of `scale`. 0 where `scale` is not representable; infinite
// where what was found is not finite.
[[nodiscard]] double relativeError(const Vec3& found, const RealVec3& exact, double scale);
// In radians, roughly: the sine, and 2 more where the two point apart.
[[nodiscard]] double angleBetween(const Vec3& found, const RealVec3& exact);

}  // namespace knotspan::testing
