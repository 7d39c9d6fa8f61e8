#include "model/geometry/bezier_conversion.h"

#include <array>

#include "model/core/check.h"
#include "model/geometry/basis.h"

namespace knotspan {

std::vector<double> bezierMatrix(const KnotVector& knots, int span)
{
    const int p = knots.degree();
    const double start = knots[span];
    const double end = knots[span + 1];
    check(start < end, "a span has a length");
    std::vector<double> matrix;
    matrix.reserve(static_cast<size_t>((p + 1) * (p + 1)));
    for (int k = 0; k <= p; ++k) {
        // Both shares of a step come from differences of knots that are not negative, so nothing cancels; a
        // share of 0 or 1 is exact, so that a border gets the same bits from both sides.
        BasisRow row{1.0};
        for (int d = 1; d <= p; ++d)
            raiseDegree(knots, span, d <= k ? end : start, d, row);
        matrix.insert(matrix.end(), row.begin(), row.begin() + p + 1);
    }
    return matrix;
}

namespace {

SpanNumbers<double> matricesOf(const KnotVector& knots)
{
    return {knots, [&knots](int span, std::vector<double>& numbers) {
                const std::vector<double> matrix = bezierMatrix(knots, span);
                numbers.insert(numbers.end(), matrix.begin(), matrix.end());
            }};
}

}  // namespace

BezierConversion::BezierConversion(const NurbsSurface& surface, const Vec3& origin)
    : surface_(surface),
      origin_(origin),
      alongU_(matricesOf(surface.knotsU())),
      alongV_(matricesOf(surface.knotsV()))
{
}

BezierNet BezierConversion::net(const KsQuad& quad) const
{
    const int p = surface_.degreeU();
    const int q = surface_.degreeV();
    const double* const matrixU = alongU_.data() + alongU_.startOf(quad.spanU);
    const double* const matrixV = alongV_.data() + alongV_.startOf(quad.spanV);
    BezierNet result{p, q, std::vector<Vec4>(static_cast<size_t>((p + 1) * (q + 1)), Vec4(0))};
    for (int i = 0; i <= p; ++i) {
        std::array<Vec4, kMaxDegree + 1> given;
        for (int j = 0; j <= q; ++j) {
            const ControlPoint& point = surface_.controlPoint(quad.spanU - p + i, quad.spanV - q + j);
            given[static_cast<size_t>(j)] = {point.weight * (point.position - origin_), point.weight};
        }
        for (int l = 0; l <= q; ++l) {
            Vec4 sum(0);
            for (int j = 0; j <= q; ++j)
                sum += matrixV[l * (q + 1) + j] * given[static_cast<size_t>(j)];
            for (int k = 0; k <= p; ++k)
                result.at(k, l) += matrixU[k * (p + 1) + i] * sum;
        }
    }
    return result;
}

BezierNet transformed(const BezierNet& net, const Mat4& matrix)
{
    BezierNet result = net;
    for (Vec4& point : result.points)
        point = matrix * point;
    return result;
}

namespace {

// The points of one row, `stride` apart: the part below t stays, the part above goes to `upper`.
void splitRow(Vec4* lower, Vec4* upper, int degree, int stride, double t)
{
    for (int level = 0; level <= degree; ++level) {
        upper[(degree - level) * stride] = lower[degree * stride];
        // At the middle written so that a row read backwards gives the same bits.
        for (int k = degree; k > level; --k) {
            const Vec4& a = lower[(k - 1) * stride];
            const Vec4& b = lower[k * stride];
            lower[k * stride] = t == 0.5 ? (a + b) * 0.5 : (1 - t) * a + t * b;
        }
    }
}

}  // namespace

std::pair<BezierNet, BezierNet> split(const BezierNet& net, Direction direction, double t)
{
    std::pair<BezierNet, BezierNet> parts(net, net);
    const bool alongU = direction == Direction::U;
    const int row = net.degreeV + 1;
    const int rows = alongU ? net.degreeV : net.degreeU;
    for (int k = 0; k <= rows; ++k) {
        const int first = alongU ? k : k * row;
        splitRow(parts.first.points.data() + first, parts.second.points.data() + first,
                 alongU ? net.degreeU : net.degreeV, alongU ? row : 1, t);
    }
    return parts;
}

BezierNet boundary(const BezierNet& net, Side side)
{
    const bool alongV = side == Side::startU || side == Side::endU;
    BezierNet curve{alongV ? net.degreeV : net.degreeU, 0, {}};
    for (int k = 0; k <= curve.degreeU; ++k) {
        if (alongV)
            curve.points.push_back(net.at(side == Side::startU ? 0 : net.degreeU, k));
        else
            curve.points.push_back(net.at(k, side == Side::startV ? 0 : net.degreeV));
    }
    return curve;
}

namespace {

// By repeated linear interpolation: convex combinations only.
Vec4 pointOf(Vec4* points, int degree, double t)
{
    for (int level = degree; level > 0; --level)
        for (int k = 0; k < level; ++k)
            points[k] = (1 - t) * points[k] + t * points[k + 1];
    return points[0];
}

}  // namespace

Vec4 evaluate(const BezierNet& net, double u, double v)
{
    std::array<Vec4, kMaxDegree + 1> column;
    for (int i = 0; i <= net.degreeU; ++i) {
        std::array<Vec4, kMaxDegree + 1> row;
        for (int j = 0; j <= net.degreeV; ++j)
            row[static_cast<size_t>(j)] = net.at(i, j);
        column[static_cast<size_t>(i)] = pointOf(row.data(), net.degreeV, v);
    }
    return pointOf(column.data(), net.degreeU, u);
}

}  // namespace knotspan
