#include "model/friends/edge_strip.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "model/analysis/bezier_curves.h"
#include "model/friends/trim_strips.h"

namespace knotspan {

std::vector<Vec4> part(std::vector<Vec4> points, double start, double end)
{
    const double low = std::min(start, end);
    const double high = std::max(start, end);
    const size_t degree = points.size() - 1;
    if (high < 1.0)
        for (size_t level = 1; level <= degree; ++level)
            for (size_t k = degree; k >= level; --k)
                points[k] = (1 - high) * points[k - 1] + high * points[k];
    if (low > 0.0) {
        const double t = low / high;
        for (size_t level = 1; level <= degree; ++level)
            for (size_t k = 0; k + level <= degree; ++k)
                points[k] = (1 - t) * points[k] + t * points[k + 1];
    }
    if (start > end)
        std::reverse(points.begin(), points.end());
    return points;
}

void projective(std::vector<Vec4>& row, double factor)
{
    double power = 1;
    for (size_t k = 1; k < row.size(); ++k)
        row[k] *= power *= factor;
}

namespace {

// Across an edge and along it, whichever of u and v they are.
struct Net {
    const NurbsSurface& surface;
    bool acrossU;
    Vec3 centre;
    Mat4 linear;

    [[nodiscard]] const KnotVector& across() const { return acrossU ? surface.knotsU() : surface.knotsV(); }
    [[nodiscard]] const KnotVector& along() const { return acrossU ? surface.knotsV() : surface.knotsU(); }
    [[nodiscard]] Vec4 point(int i, int k) const
    {
        const ControlPoint& given = acrossU ? surface.controlPoint(i, k) : surface.controlPoint(k, i);
        return {given.weight * (glm::dmat3(linear) * (given.position - centre)), given.weight};
    }
};

bool isTrimmed(const PlacedSurface& placed)
{
    return placed.trimLoops != nullptr && !placed.trimLoops->empty();
}

using Rows = std::array<std::vector<Vec4>, 3>;

// The edge's B-spline curve and those of its derivatives into the surface.
Rows rowsOf(const Net& net, bool atEnd)
{
    const KnotVector& across = net.across();
    const int p = across.degree();
    const int span = atEnd ? across.spans().back() : across.spans().front();
    const std::vector<double> matrix = bezierMatrix(across, span);
    const int count = net.along().controlPointCount();
    Rows bezier;  // the three Bézier rows nearest the edge
    for (int row = 0; row < std::min(3, p + 1); ++row) {
        auto& points = bezier[static_cast<size_t>(row)];
        points.assign(static_cast<size_t>(count), Vec4(0));
        const double* const shares = matrix.data() + (atEnd ? p - row : row) * (p + 1);
        for (int i = 0; i <= p; ++i)
            if (shares[i] != 0.0)
                for (int k = 0; k < count; ++k)
                    points[static_cast<size_t>(k)] += shares[i] * net.point(span - p + i, k);
    }
    Rows rows = bezier;
    rows[2].resize(static_cast<size_t>(count), Vec4(0));
    for (size_t k = 0; k < static_cast<size_t>(count); ++k) {
        rows[1][k] = static_cast<double>(p) * (bezier[1][k] - bezier[0][k]);
        if (p > 1)
            rows[2][k] = static_cast<double>(p * (p - 1)) *
                         ((bezier[2][k] - bezier[1][k]) - (bezier[1][k] - bezier[0][k]));
    }
    return rows;
}

std::vector<Vec4> onSpan(const std::vector<double>& matrix, const std::vector<Vec4>& row, int degree,
                         int span)
{
    std::vector<Vec4> result(static_cast<size_t>(degree + 1), Vec4(0));
    for (int k = 0; k <= degree; ++k)
        for (int i = 0; i <= degree; ++i)
            result[static_cast<size_t>(k)] += matrix[static_cast<size_t>(k * (degree + 1) + i)] *
                                              row[static_cast<size_t>(span - degree + i)];
    return result;
}

// Weights of 1 at most, or all 1.
void scaleWeights(EdgeRows& rows)
{
    double heaviest = 0;
    double lightest = rows.at[0].w;
    double change = 0;
    for (size_t k = 0; k < rows.at.size(); ++k) {
        heaviest = std::max(heaviest, rows.at[k].w);
        lightest = std::min(lightest, rows.at[k].w);
        change = std::max({change, std::abs(rows.into[k].w), std::abs(rows.bend[k].w)});
    }
    constexpr double kRounding = 1e-13;
    rows.rational = heaviest - lightest > kRounding * heaviest || change > kRounding * heaviest;
    for (auto* const row : {&rows.at, &rows.into, &rows.bend})
        for (Vec4& point : *row) {
            point /= heaviest;
            if (!rows.rational)
                point.w = row == &rows.at ? 1.0 : 0.0;
        }
}

EdgeStrip stripOf(const Net& net, bool atEnd, const std::vector<std::vector<double>>& matrices)
{
    EdgeStrip strip;
    const Rows rows = rowsOf(net, atEnd);
    const KnotVector& along = net.along();
    strip.origin = Vec3(net.linear * Vec4(net.centre, 1.0));
    for (size_t n = 0; n < along.spans().size(); ++n) {
        const int span = along.spans()[n];
        EdgePiece piece;
        piece.from = along[span];
        piece.to = along[span + 1];
        piece.rows.at = onSpan(matrices[n], rows[0], along.degree(), span);
        piece.rows.into = onSpan(matrices[n], rows[1], along.degree(), span);
        piece.rows.bend = onSpan(matrices[n], rows[2], along.degree(), span);
        complete(piece, strip.origin);
        strip.pieces.push_back(std::move(piece));
    }
    return strip;
}

// In the order of `Side`.
std::vector<EdgeStrip> sideStrips(const PlacedSurface& placed)
{
    const NurbsSurface& surface = *placed.surface;
    std::vector<EdgeStrip> strips;
    for (const bool acrossU : {true, false}) {
        const Net net{surface, acrossU, surface.bounds().centre(), placed.transform};
        std::vector<std::vector<double>> matrices;
        for (const int span : net.along().spans())
            matrices.push_back(bezierMatrix(net.along(), span));
        for (const bool atEnd : {false, true}) {
            strips.push_back(stripOf(net, atEnd, matrices));
            strips.back().edge.side = static_cast<Side>((acrossU ? 0 : 2) + (atEnd ? 1 : 0));
        }
    }
    return strips;
}

}  // namespace

EdgeRows part(const EdgeRows& rows, double start, double end)
{
    return {part(rows.at, start, end), part(rows.into, start, end), part(rows.bend, start, end),
            rows.rational};
}

double EdgeStrip::length() const
{
    double sum = 0;
    for (const EdgePiece& piece : pieces)
        sum += piece.length;
    return sum;
}

bool EdgeStrip::sameAs(const EdgeStrip& other) const
{
    return origin == other.origin && reach == other.reach && size == other.size &&
           std::equal(pieces.begin(), pieces.end(), other.pieces.begin(), other.pieces.end(),
                      [](const EdgePiece& a, const EdgePiece& b) {
                          return a.from == b.from && a.to == b.to && a.rows == b.rows;
                      });
}

void complete(EdgePiece& piece, const Vec3& origin)
{
    scaleWeights(piece.rows);
    const auto& points = piece.rows.at;
    for (const Vec4& point : points)
        piece.box.add(origin + pointOf(point));
    const Vec3 chord = pointOf(points.back()) - pointOf(points.front());
    const double size = glm::length(chord);
    piece.axis = size > 0 ? chord / size : Vec3(0);
    for (size_t k = 0; k + 1 < points.size(); ++k) {
        const Vec3 leg = pointOf(points[k + 1]) - pointOf(points[k]);
        const double length = glm::length(leg);
        piece.length += length;
        if (length > 0)
            piece.spread =
                std::max(piece.spread, std::acos(std::clamp(glm::dot(leg, piece.axis) / length, -1.0, 1.0)));
    }
    if (!(piece.spread < std::numbers::pi / 2))
        piece.spread = std::numbers::pi;
    for (size_t k = 0; k < kEdgeSamples; ++k)
        piece.samples[k] = pointOf(part(points, 0, static_cast<double>(k) / (kEdgeSamples - 1)).back());
}

size_t edgeCount(const PlacedSurface& placed)
{
    if (!isTrimmed(placed))
        return 4;
    size_t count = 0;
    for (const TrimLoop& loop : *placed.trimLoops)
        count += loop.curves.size();
    return count;
}

std::vector<EdgeStrip> edgeStrips(std::uint32_t index, const PlacedSurface& placed, double deviation)
{
    const Box box = transformed(placed.surface->bounds(), placed.transform);
    constexpr double kRounding = 1e-12;
    std::vector<EdgeStrip> strips = isTrimmed(placed)
                                        ? trimStrips(placed, std::max(deviation, kRounding * box.diagonal()))
                                        : sideStrips(placed);
    for (EdgeStrip& strip : strips) {
        strip.edge.surface = index;
        strip.edge.from = strip.pieces.front().from;
        strip.edge.to = strip.pieces.back().to;
        strip.size = box.diagonal();
        for (int axis = 0; axis < 3; ++axis)
            strip.reach = std::max({strip.reach, std::abs(box.low[axis]), std::abs(box.high[axis])});
        for (const EdgePiece& piece : strip.pieces)
            strip.box.add(piece.box);
    }
    return strips;
}

}  // namespace knotspan
