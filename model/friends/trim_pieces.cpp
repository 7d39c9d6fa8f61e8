#include "model/friends/trim_pieces.h"

#include <array>
#include <cmath>
#include <optional>

#include "model/analysis/bezier_curves.h"
#include "model/friends/edge_strip.h"

namespace knotspan {

namespace {

using Curve = std::vector<Vec4>;      // (w u, w v, 0, w), Bernstein coefficients
constexpr double kLeastShare = 1e-9;  // of a curve's span, that is cut no more
constexpr int kMostHalvings = 9;

Vec3 place(const Curve& curve, double t)
{
    return pointOf(part(curve, 0, t).back());
}

// A polynomial that agrees with values at its degree + 1 places, evenly from 0 to 1: Bernstein coefficients.
Scalars interpolated(const std::vector<double>& f)
{
    switch (f.size()) {
    case 2:
        return f;
    case 3:
        return {f[0], 2 * f[1] - (f[0] + f[2]) / 2, f[2]};
    default:
        return {f[0], (-5 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / 6,
                (2 * f[0] - 9 * f[1] + 18 * f[2] - 5 * f[3]) / 6, f[3]};
    }
}

class Cutting {
public:
    Cutting(const KnotVector& knotsU, const KnotVector& knotsV, const TrimAccuracy& accuracy)
        : knots_{&knotsU, &knotsV},
          accuracy_(accuracy)
    {
    }

    // `halvings`: since it lies in one KSQuad.
    void add(const Curve& curve, double from, double to, int halvings = 0)
    {
        const bool divisible = to - from > kLeastShare * (last_ - first_);
        if (const auto cut = divisible ? crossing(curve) : std::nullopt)
            return addHalves(curve, from, to, *cut, 0);
        const TrimPiece piece = fitted(curve, from, to);
        if (divisible && halvings < kMostHalvings && piece.deviation > accuracy_.deviation)
            return addHalves(curve, from, to, 0.5, halvings + 1);
        pieces_.push_back(piece);
    }
    void startSpan(double first, double last)
    {
        first_ = first;
        last_ = last;
    }

    std::vector<TrimPiece> taken() { return std::move(pieces_); }

private:
    void addHalves(const Curve& curve, double from, double to, double at, int halvings)
    {
        const double middle = from + at * (to - from);
        add(part(curve, 0, at), from, middle, halvings);
        add(part(curve, at, 1), middle, to, halvings);
    }

    // Where to cut a curve that may not lie in one KSQuad: at the knot line, if one is between its ends.
    [[nodiscard]] std::optional<double> crossing(const Curve& curve) const
    {
        for (const int axis : {0, 1}) {
            double low = std::numeric_limits<double>::infinity();
            double high = -low;
            for (const Vec4& point : curve) {
                low = std::min(low, pointOf(point)[axis]);
                high = std::max(high, pointOf(point)[axis]);
            }
            const KnotVector& knots = *knots_[static_cast<size_t>(axis)];
            const double near = 1e-9 * (knots.domainEnd() - knots.domainStart());
            for (const int span : knots.spans()) {
                const double knot = knots[span];
                if (knot <= knots.domainStart() || !(low < knot - near && knot + near < high))
                    continue;
                const double start = pointOf(curve.front())[axis] - knot;
                const double end = pointOf(curve.back())[axis] - knot;
                if (std::abs(start) > near && std::abs(end) > near && (start < 0) != (end < 0))
                    return placeOf(curve, axis, knot);
                return 0.5;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] static double placeOf(const Curve& curve, int axis, double knot)
    {
        double low = 0;
        double high = 1;
        const bool rises = pointOf(curve.front())[axis] < knot;
        for (int step = 0; step < 52; ++step) {
            const double middle = (low + high) / 2;
            ((place(curve, middle)[axis] < knot) == rises ? low : high) = middle;
        }
        // Never so near to an end that one part is nothing.
        return std::clamp((low + high) / 2, 1e-6, 1 - 1e-6);
    }

    [[nodiscard]] TrimPiece fitted(const Curve& curve, double from, double to) const
    {
        const Vec3 middle = place(curve, 0.5);
        const Vec3 way = place(curve, 0.75) - place(curve, 0.25);
        TrimPiece piece;
        piece.from = from;
        piece.to = to;
        piece.spanU = spanAt(0, middle.x, -way.y);
        piece.spanV = spanAt(1, middle.y, way.x);
        const Vec2 speeds = accuracy_.speeds(piece.spanU, piece.spanV);
        for (int degree = 1; degree <= accuracy_.degree; ++degree) {
            const double offU = fit(curve, 0, piece.spanU, degree, piece.u);
            const double offV = fit(curve, 1, piece.spanV, degree, piece.v);
            piece.deviation = offU * speeds.x + offV * speeds.y;
            if (piece.deviation <= accuracy_.deviation)
                break;
        }
        return piece;
    }

    // The span of a place, on a knot line the one that lies in the direction of `side`.
    [[nodiscard]] int spanAt(int axis, double at, double side) const
    {
        const KnotVector& knots = *knots_[static_cast<size_t>(axis)];
        const double near = 2e-9 * (knots.domainEnd() - knots.domainStart());
        return knots.findSpan(at + std::copysign(near, side));
    }

    // How far off, at most.
    [[nodiscard]] double fit(const Curve& curve, int axis, int span, int degree, Scalars& result) const
    {
        const KnotVector& knots = *knots_[static_cast<size_t>(axis)];
        const double start = knots[span];
        const double length = knots[span + 1] - start;
        std::vector<double> values;
        for (int k = 0; k <= degree; ++k)
            values.push_back((place(curve, static_cast<double>(k) / degree)[axis] - start) / length);
        result = interpolated(values);
        // A place at the KSQuad's border, but for rounding, is one there.
        constexpr double kRounding = 1e-12;
        bool constant = true;
        for (double& value : result) {
            if (std::abs(value - std::round(value)) <= kRounding)
                value = std::round(value);
            constant = constant && std::abs(value - result[0]) <= kRounding;
        }
        if (constant)
            result.resize(1);
        Scalars wanted;
        Scalars weights;
        for (const Vec4& point : curve) {
            wanted.push_back((point[axis] - point.w * start) / length);
            weights.push_back(point.w);
        }
        const double least = *std::min_element(weights.begin(), weights.end());
        double off = 0;
        for (const double value :
             bernsteinOf(difference(scaledOf(wanted), scaledOf(weights) * scaledOf(result))))
            off = std::max(off, std::abs(value) / least);
        return off;
    }

    std::array<const KnotVector*, 2> knots_;
    const TrimAccuracy& accuracy_;
    double first_ = 0;
    double last_ = 1;
    std::vector<TrimPiece> pieces_;
};

}  // namespace

std::vector<TrimPiece> trimPieces(const TrimCurve& curve, const KnotVector& knotsU, const KnotVector& knotsV,
                                  const TrimAccuracy& accuracy)
{
    Cutting cutting(knotsU, knotsV, accuracy);
    const KnotVector& knots = curve.knots();
    const auto order = static_cast<size_t>(knots.degree() + 1);
    for (const int span : knots.spans()) {
        const std::vector<double> matrix = bezierMatrix(knots, span);
        Curve bezier(order, Vec4(0));
        for (size_t k = 0; k < order; ++k)
            for (size_t i = 0; i < order; ++i) {
                const TrimPoint& point = curve.points()[static_cast<size_t>(span) + 1 - order + i];
                bezier[k] += matrix[k * order + i] * point.weight * Vec4(point.position, 0, 1);
            }
        cutting.startSpan(knots[span], knots[span + 1]);
        cutting.add(bezier, knots[span], knots[span + 1]);
    }
    return cutting.taken();
}

}  // namespace knotspan
