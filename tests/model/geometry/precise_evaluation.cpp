#include "tests/model/geometry/precise_evaluation.h"

#include <algorithm>

namespace knotspan::testing {

namespace {

using RealVec4 = std::array<Real, 4>;
using Points = std::vector<RealVec4>;

// The knots around one span that matter to its degree + 1 functions, and the parameter.
class PreciseSpan {
public:
    PreciseSpan(const KnotVector& knots, int span, const Real& u) : degree_(knots.degree())
    {
        const auto first = knots.values().begin() + span - degree_;
        local_.assign(first, first + 2 * degree_ + 2);
        for (int order = 0; order <= std::min(2, degree_); ++order) {
            const int p = degree_ - order;
            for (int r = 1; r <= p; ++r)
                for (int j = p; j >= r; --j) {
                    const Real& low = knot(order + j);
                    alphas_[static_cast<size_t>(order)].push_back((u - low) /
                                                                  (knot(order + j + 1 + p - r) - low));
                }
        }
    }

    // The `order`-th derivative of the curve with these degree + 1 control points.
    [[nodiscard]] RealVec4 derivative(Points points, int order) const
    {
        if (order > degree_)
            return {};
        for (int k = 0; k < order; ++k)
            points = differences(points, k);
        // de Boor's algorithm.
        const int p = degree_ - order;
        auto alpha = alphas_[static_cast<size_t>(order)].begin();
        for (int r = 1; r <= p; ++r)
            for (int j = p; j >= r; --j, ++alpha) {
                const Real rest = 1 - *alpha;  // both positive: nothing cancels, whatever the weights
                for (size_t c = 0; c < 4; ++c) {
                    Real& at = points[static_cast<size_t>(j)][c];
                    at = *alpha * at + rest * points[static_cast<size_t>(j) - 1][c];
                }
            }
        return points.back();
    }

private:
    [[nodiscard]] const Real& knot(int index) const { return local_[static_cast<size_t>(index)]; }

    // From the k-th derivative's control points to the next one's.
    [[nodiscard]] Points differences(const Points& points, int k) const
    {
        const int p = degree_ - k;
        Points result(points.size() - 1);
        for (int i = 0; i < p; ++i) {
            const Real rate = p / (knot(k + i + p + 1) - knot(k + i + 1));
            for (size_t c = 0; c < 4; ++c)
                result[static_cast<size_t>(i)][c] =
                    rate * (points[static_cast<size_t>(i) + 1][c] - points[static_cast<size_t>(i)][c]);
        }
        return result;
    }

    int degree_;
    std::vector<Real> local_;
    std::array<std::vector<Real>, 3> alphas_;  // by order, as the algorithm needs them
};

RealVec4 homogeneous(const ControlPoint& point)
{
    const Real w = point.weight;
    return {w * Real(point.position.x), w * Real(point.position.y), w * Real(point.position.z), w};
}

}  // namespace

PrecisePoint preciseEvaluation(const NurbsSurface& surface, int spanU, const Real& u, int spanV,
                               const Real& v)
{
    const PreciseSpan alongU(surface.knotsU(), spanU, u);
    const PreciseSpan alongV(surface.knotsV(), spanV, v);
    std::array<Points, 3> columns;  // by the order along v
    for (int i = spanU - surface.degreeU(); i <= spanU; ++i) {
        Points row;
        for (int j = spanV - surface.degreeV(); j <= spanV; ++j)
            row.push_back(homogeneous(surface.controlPoint(i, j)));
        for (int order = 0; order < 3; ++order)
            columns[static_cast<size_t>(order)].push_back(alongV.derivative(row, order));
    }
    const RealVec4 a = alongU.derivative(columns[0], 0);
    const RealVec4 au = alongU.derivative(columns[0], 1);
    const RealVec4 av = alongU.derivative(columns[1], 0);
    const RealVec4 auu = alongU.derivative(columns[0], 2);
    const RealVec4 auv = alongU.derivative(columns[1], 1);
    const RealVec4 avv = alongU.derivative(columns[2], 0);
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

PrecisePoint preciseEvaluation(const NurbsSurface& surface, double u, double v)
{
    return preciseEvaluation(surface, surface.knotsU().findSpan(u), u, surface.knotsV().findSpan(v), v);
}

Real parameterOnSpan(const KnotVector& knots, int span, double t)
{
    const Real start = knots[span];
    return start + (Real(knots[span + 1]) - start) * Real(t);
}

RealVec3 cross(const RealVec3& a, const RealVec3& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real dot(const RealVec3& a, const RealVec3& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Real length(const RealVec3& a)
{
    return sqrt(dot(a, a));
}

}  // namespace knotspan::testing
