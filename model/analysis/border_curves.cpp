#include "model/analysis/border_curves.h"

namespace knotspan {

std::uint32_t BorderNumbers::corner(std::uint32_t i, std::uint32_t j) const
{
    if (j == 0)
        return firstBorder + i;
    if (j == spansV)
        return firstBorder + spansU + 1 + i;
    return firstBorder + 2 * (spansU + 1) + (i == 0 ? 0 : spansV - 1) + j - 1;
}

std::array<std::uint32_t, 2> BorderNumbers::cornersOf(std::uint32_t k) const
{
    if (k < 2 * spansV) {
        const std::uint32_t i = k < spansV ? 0 : spansU;
        return {corner(i, k % spansV), corner(i, k % spansV + 1)};
    }
    const std::uint32_t along = (k - 2 * spansV) % spansU;
    const std::uint32_t j = k - 2 * spansV < spansU ? 0 : spansV;
    return {corner(along, j), corner(along + 1, j)};
}

std::uint32_t BorderNumbers::sideName(std::uint32_t k) const
{
    if (k < spansV)
        return 4 * (firstKsquad + k);
    if (k < 2 * spansV)
        return 4 * (firstKsquad + (spansU - 1) * spansV + k - spansV) + 1;
    k -= 2 * spansV;
    if (k < spansU)
        return 4 * (firstKsquad + k * spansV) + 2;
    return 4 * (firstKsquad + (k - spansU) * spansV + spansV - 1) + 3;
}

std::uint32_t BorderNumbers::cornerName(std::uint32_t i, std::uint32_t j) const
{
    const std::uint32_t a = i > 0 ? i - 1 : 0;
    const std::uint32_t b = j > 0 ? j - 1 : 0;
    return 4 * (firstKsquad + a * spansV + b) + (i > 0 ? 1 : 0) + (j > 0 ? 2 : 0);
}

std::vector<BorderNumbers> borderNumbers(const std::vector<PlacedSurface>& surfaces)
{
    std::vector<BorderNumbers> numbers;
    numbers.reserve(surfaces.size());
    std::uint32_t firstKsquad = 0;
    std::uint32_t firstBorder = 0;
    for (const PlacedSurface& placed : surfaces) {
        numbers.push_back({static_cast<std::uint32_t>(placed.surface->knotsU().spans().size()),
                           static_cast<std::uint32_t>(placed.surface->knotsV().spans().size()), firstKsquad,
                           firstBorder});
        firstKsquad += numbers.back().spansU * numbers.back().spansV;
        firstBorder += numbers.back().borderCount();
    }
    return numbers;
}

namespace {

// The control points of the surface's border as one B-spline curve; point(i, k): i counts across, k along.
template <class Point>
std::vector<Vec4> borderRow(const KnotVector& across, int count, bool atEnd, const Point& point)
{
    const int p = across.degree();
    const int span = atEnd ? across.spans().back() : across.spans().front();
    const std::vector<double> matrix = bezierMatrix(across, span);
    const double* const shares = matrix.data() + (atEnd ? p * (p + 1) : 0);
    std::vector<Vec4> row(static_cast<size_t>(count), Vec4(0));
    for (int i = 0; i <= p; ++i)
        if (shares[i] != 0.0)
            for (int k = 0; k < count; ++k)
                row[static_cast<size_t>(k)] += shares[i] * point(span - p + i, k).homogeneous();
    return row;
}

void appendCurves(std::vector<BezierNet>& curves, const KnotVector& along, const std::vector<Vec4>& row)
{
    const int p = along.degree();
    for (const int span : along.spans()) {
        const std::vector<double> matrix = bezierMatrix(along, span);
        BezierNet curve{p, 0, std::vector<Vec4>(static_cast<size_t>(p + 1), Vec4(0))};
        for (int k = 0; k <= p; ++k)
            for (int i = 0; i <= p; ++i)
                curve.at(k, 0) +=
                    matrix[static_cast<size_t>(k * (p + 1) + i)] * row[static_cast<size_t>(span - p + i)];
        curves.push_back(std::move(curve));
    }
}

}  // namespace

std::vector<BezierNet> borderCurves(const PlacedSurface& placed)
{
    const NurbsSurface& surface = *placed.surface;
    const auto transformedRow = [&](std::vector<Vec4> row) {
        for (Vec4& point : row)
            point = placed.transform * point;
        return row;
    };
    std::vector<BezierNet> curves;
    for (const bool atEnd : {false, true})
        appendCurves(curves, surface.knotsV(),
                     transformedRow(borderRow(
                         surface.knotsU(), surface.countV(), atEnd,
                         [&](int i, int k) -> const ControlPoint& { return surface.controlPoint(i, k); })));
    for (const bool atEnd : {false, true})
        appendCurves(curves, surface.knotsU(),
                     transformedRow(borderRow(
                         surface.knotsV(), surface.countU(), atEnd,
                         [&](int i, int k) -> const ControlPoint& { return surface.controlPoint(k, i); })));
    return curves;
}

}  // namespace knotspan
