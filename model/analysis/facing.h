// Which sides of a KSQuad an eye can see, exactly: one polynomial whose sign is the facing of every point.
//
// With X the KSQuad's homogeneous points, F(u, v) = det[(e, 1); X; X_u; X_v] = w^3 (S_u x S_v) . (e - S) is
// negative where the point faces away from an eye e. F = T(u, v) . (e, 1), and T depends on the shape alone:
// a camera move changes none of it.
#pragma once

#include <vector>

#include "model/geometry/bezier_conversion.h"

namespace knotspan {

// The Bernstein coefficients of T over the KSQuad's [0, 1] x [0, 1], by its t in both directions, in
// coordinates of the net. Coefficient (k, l) of (degreeU + 1) x (degreeV + 1) is stored at k * (degreeV + 1)
// + l.
struct FacingNet {
    int degreeU = 0;  // 3 p - 2
    int degreeV = 0;  // 3 q - 2
    std::vector<Vec4> points;
};

// Of a net of degrees of at least 1. `rounding`: how far off, for its length, each of the net's homogeneous
// points may be. A coefficient that is no larger than what this makes of nothing is set to zero: at a pole
// control points that ought to be one may differ in their last place, and the normal of that speck would tell
// nothing. The net should be small numbers around its own origin, and its weights and coordinates of about
// one size.
[[nodiscard]] FacingNet facingNet(const BezierNet& net, double rounding = 1e-15);
// The same into `facing`, whose memory is used again.
void makeFacingNet(const BezierNet& net, double rounding, FacingNet& facing);

// Whether all of the KSQuad provably faces away from `eye`, (e, 1) or, of an orthographic view, (direction
// towards the eye, 0), in the net's coordinates: every coefficient that is not zero has T . eye <= -margin
// |T| |eye|. Never where all are zero.
[[nodiscard]] bool facesAway(const FacingNet& facing, const Vec4& eye, double margin = 0);

}  // namespace knotspan
