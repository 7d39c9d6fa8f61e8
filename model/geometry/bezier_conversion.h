// The Bézier net of one KSQuad: the same rational polynomial over [0, 1] x [0, 1], whose control points
// enclose it far more closely than the surface's own.
//
// It comes straight from the knots around the KSQuad and the (p+1)(q+1) control points that shape it; the
// surface as a whole is never refined.
#pragma once

#include <utility>
#include <vector>

#include "model/geometry/knot_insertion.h"
#include "model/geometry/ksquad.h"
#include "model/geometry/span_numbers.h"

namespace knotspan {

// Homogeneous points (w x, w y, w z, w); point (i, j) of (degreeU + 1) x (degreeV + 1) is stored at
// i * (degreeV + 1) + j. A curve is a net with degreeV = 0.
struct BezierNet {
    int degreeU = 0;
    int degreeV = 0;
    std::vector<Vec4> points;

    [[nodiscard]] const Vec4& at(int i, int j) const { return points[index(i, j)]; }
    [[nodiscard]] Vec4& at(int i, int j) { return points[index(i, j)]; }

    [[nodiscard]] bool operator==(const BezierNet&) const = default;

private:
    [[nodiscard]] size_t index(int i, int j) const
    {
        return static_cast<size_t>(i) * static_cast<size_t>(degreeV + 1) + static_cast<size_t>(j);
    }
};

// Makes the nets of all KSQuads of a surface; keeps a reference to it. What depends on the knots alone, a
// matrix for each span and direction, is made once; its entries are not negative, sum to 1 in each row and
// are right to a few units of their last place, for any knots.
class BezierConversion {
public:
    // Points are given relative to `origin`, subtracted before anything is multiplied.
    explicit BezierConversion(const NurbsSurface& surface, const Vec3& origin = Vec3(0));

    // Two KSQuads beside each other have the same bits on the border between them where it is no crease.
    [[nodiscard]] BezierNet net(const KsQuad& quad) const;

private:
    const NurbsSurface& surface_;
    Vec3 origin_;
    SpanNumbers<double> alongU_;
    SpanNumbers<double> alongV_;
};

// Point b_k of a Bézier curve is the blossom of the B-spline curve at (degree - k) times the span's start and
// k times its end. Row k: how much each of the degree + 1 control points that shape the span counts for it.
[[nodiscard]] std::vector<double> bezierMatrix(const KnotVector& knots, int span);

// Each homogeneous point multiplied by `matrix`.
[[nodiscard]] BezierNet transformed(const BezierNet& net, const Mat4& matrix);

// The two parts below and above t (de Casteljau); each again over [0, 1] x [0, 1].
[[nodiscard]] std::pair<BezierNet, BezierNet> split(const BezierNet& net, Direction direction,
                                                    double t = 0.5);

// The boundary curves u = 0 (or 1) and v = 0 (or 1), as curves.
enum class Side { startU, endU, startV, endV };
[[nodiscard]] BezierNet boundary(const BezierNet& net, Side side);

// The homogeneous point at (u, v) in [0, 1] x [0, 1].
[[nodiscard]] Vec4 evaluate(const BezierNet& net, double u, double v);

}  // namespace knotspan
