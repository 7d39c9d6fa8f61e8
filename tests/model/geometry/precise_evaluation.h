// An independent evaluation in 50 decimal digits: de Boor's algorithm on the homogeneous net, derivatives as
// B-splines of difference points. It shares no formula with the product's triangular tables.
#pragma once

#include <array>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan::testing {

using Real = boost::multiprecision::cpp_bin_float_50;
using RealVec4 = std::array<Real, 4>;

struct PreciseCurve {
    int degree;
    std::vector<Real> knots;
    std::vector<RealVec4> points;
};

[[nodiscard]] inline PreciseCurve derivative(const PreciseCurve& curve)
{
    const int p = curve.degree;
    if (p == 0)
        return {0, curve.knots, std::vector<RealVec4>(curve.points.size(), RealVec4{})};
    PreciseCurve result{p - 1, {curve.knots.begin() + 1, curve.knots.end() - 1}, {}};
    for (size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const Real length = curve.knots[i + static_cast<size_t>(p) + 1] - curve.knots[i + 1];
        RealVec4 point{};
        for (size_t c = 0; c < 4; ++c)
            if (length != 0)
                point[c] = p * (curve.points[i + 1][c] - curve.points[i][c]) / length;
        result.points.push_back(point);
    }
    return result;
}

// de Boor's algorithm; `span` is the index in curve.knots.
[[nodiscard]] inline RealVec4 value(const PreciseCurve& curve, int span, const Real& u)
{
    const int p = curve.degree;
    std::vector<RealVec4> d(curve.points.begin() + span - p, curve.points.begin() + span + 1);
    for (int r = 1; r <= p; ++r)
        for (int j = p; j >= r; --j) {
            const Real& low = curve.knots[static_cast<size_t>(j + span - p)];
            const Real alpha = (u - low) / (curve.knots[static_cast<size_t>(j + 1 + span - r)] - low);
            for (size_t c = 0; c < 4; ++c)
                d[static_cast<size_t>(j)][c] =
                    (1 - alpha) * d[static_cast<size_t>(j) - 1][c] + alpha * d[static_cast<size_t>(j)][c];
        }
    return d.back();
}

[[nodiscard]] inline RealVec4 derivativeAt(PreciseCurve curve, int span, const Real& u, int order)
{
    for (int k = 0; k < order; ++k) {
        if (curve.degree == 0)
            return {};
        curve = derivative(curve);
    }
    return value(curve, span - order, u);
}

// The partial derivative of the homogeneous surface.
[[nodiscard]] inline RealVec4 homogeneous(const NurbsSurface& surface, double u, double v, int orderU,
                                          int orderV)
{
    const auto reals = [](const std::vector<double>& values) {
        return std::vector<Real>(values.begin(), values.end());
    };
    PreciseCurve across{surface.degreeU(), reals(surface.knotsU().values()), {}};
    const int span = surface.knotsU().findSpan(u);
    across.points.resize(static_cast<size_t>(surface.countU()));  // those that shape no point of the span: 0
    for (int i = span - surface.degreeU(); i <= span; ++i) {
        PreciseCurve row{surface.degreeV(), reals(surface.knotsV().values()), {}};
        for (int j = 0; j < surface.countV(); ++j) {
            const ControlPoint& point = surface.controlPoint(i, j);
            const Real w = point.weight;
            row.points.push_back(
                {w * Real(point.position.x), w * Real(point.position.y), w * Real(point.position.z), w});
        }
        across.points[static_cast<size_t>(i)] = derivativeAt(row, surface.knotsV().findSpan(v), v, orderV);
    }
    return derivativeAt(across, span, u, orderU);
}

struct PrecisePoint {
    std::array<Real, 3> position, du, dv, duu, duv, dvv;
};

[[nodiscard]] inline PrecisePoint preciseEvaluation(const NurbsSurface& surface, double u, double v)
{
    const auto a = homogeneous(surface, u, v, 0, 0);
    const auto au = homogeneous(surface, u, v, 1, 0);
    const auto av = homogeneous(surface, u, v, 0, 1);
    const auto auu = homogeneous(surface, u, v, 2, 0);
    const auto auv = homogeneous(surface, u, v, 1, 1);
    const auto avv = homogeneous(surface, u, v, 0, 2);
    PrecisePoint r;
    const Real& w = a[3];
    for (size_t c = 0; c < 3; ++c) {
        // The quotient rule on A / w, component by component, not in the recursive form of A4.4.
        r.position[c] = a[c] / w;
        r.du[c] = (au[c] * w - a[c] * au[3]) / (w * w);
        r.dv[c] = (av[c] * w - a[c] * av[3]) / (w * w);
        r.duu[c] = auu[c] / w - 2 * au[c] * au[3] / (w * w) - a[c] * auu[3] / (w * w) +
                   2 * a[c] * au[3] * au[3] / (w * w * w);
        r.dvv[c] = avv[c] / w - 2 * av[c] * av[3] / (w * w) - a[c] * avv[3] / (w * w) +
                   2 * a[c] * av[3] * av[3] / (w * w * w);
        r.duv[c] = auv[c] / w - (au[c] * av[3] + av[c] * au[3] + a[c] * auv[3]) / (w * w) +
                   2 * a[c] * au[3] * av[3] / (w * w * w);
    }
    return r;
}

}  // namespace knotspan::testing
