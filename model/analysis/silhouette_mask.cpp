#include "model/analysis/silhouette_mask.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "model/analysis/grid_choice.h"
#include "model/analysis/net_on_screen.h"
#include "model/analysis/pixel_painter.h"
#include "model/geometry/bezier_conversion.h"
#include "model/geometry/grid_evaluation.h"

namespace knotspan {

namespace {

constexpr double kGridTolerance = 0.05;  // pixels: how true the triangles are
constexpr int kMostCells = 128;          // along a side of a KSQuad

Grid gridFor(const BezierNet& net, const ScreenView& view)
{
    if (!NetOnScreen(net, view).visible)
        return {};
    constexpr int kCheap = 16;
    if (const auto figures = errorFigures(net, 0, FigureForm::cheap))
        if (const auto grid = smallestGrid(*figures, kGridTolerance, kCheap))
            return *grid;
    return chooseGrid(net, view, kGridTolerance, Triangles::any, kMostCells, {8, 1, 64}).grid;
}

// For each span, as many equal cells as the finest of its KSQuads asks for.
struct SpanCells {
    std::vector<int> u;
    std::vector<int> v;
};

SpanCells spanCells(const NurbsSurface& surface, const Vec3& origin, const ScreenView& view)
{
    SpanCells cells{std::vector<int>(surface.knotsU().spans().size(), 1),
                    std::vector<int>(surface.knotsV().spans().size(), 1)};
    const BezierConversion conversion(surface, origin);
    size_t number = 0;
    for (const KsQuad& quad : ksQuads(surface)) {
        const Grid grid = gridFor(transformed(conversion.net(quad), view.toPixels), view);
        int& alongU = cells.u[number / cells.v.size()];
        int& alongV = cells.v[number % cells.v.size()];
        alongU = std::max(alongU, grid.u);
        alongV = std::max(alongV, grid.v);
        ++number;
    }
    return cells;
}

std::vector<SpanParameter> parameters(const KnotVector& knots, const std::vector<int>& cells)
{
    std::vector<SpanParameter> list;
    for (size_t s = 0; s < cells.size(); ++s)
        for (int k = 0; k < cells[s]; ++k)
            list.push_back({knots.spans()[s], static_cast<double>(k) / cells[s]});
    list.push_back({knots.spans().back(), 1.0});
    return list;
}

// The triangles of a surface, as homogeneous pixels.
class SurfaceMesh {
public:
    SurfaceMesh(const NurbsSurface& surface, const Mat4& toClip, int width, int height)
    {
        const GridEvaluator<double> evaluator(surface, {});
        Mat4 moved(1.0);
        moved[3] = Vec4(evaluator.origin(), 1.0);
        const ScreenView view = screenView(toClip * moved, width, height);
        const SpanCells cells = spanCells(surface, evaluator.origin(), view);
        GridSamples<double> samples;
        evaluator.evaluate(parameters(surface.knotsU(), cells.u), parameters(surface.knotsV(), cells.v),
                           samples);
        rows_ = samples.rows();
        columns_ = samples.columns();
        for (int i = 0; i < rows_; ++i)
            for (int j = 0; j < columns_; ++j)
                points_.push_back(view.toPixels * Vec4(samples.position(i, j), 1.0));
    }

    void paint(PixelPainter& painter) const
    {
        for (int i = 0; i + 1 < rows_; ++i)
            for (int j = 0; j + 1 < columns_; ++j) {
                painter.cover(at(i, j), at(i + 1, j), at(i + 1, j + 1));
                painter.cover(at(i, j), at(i + 1, j + 1), at(i, j + 1));
                paintFolds(painter, i, j);
            }
        for (int i = 0; i + 2 < rows_; ++i) {
            paintBorderFold(painter, {i, 0}, {1, 0}, false);
            paintBorderFold(painter, {i, columns_ - 1}, {1, 0}, true);
        }
        for (int j = 0; j + 2 < columns_; ++j) {
            paintBorderFold(painter, {0, j}, {0, 1}, true);
            paintBorderFold(painter, {rows_ - 1, j}, {0, 1}, false);
        }
    }

private:
    [[nodiscard]] const Vec4& at(int i, int j) const
    {
        return points_[static_cast<size_t>(i) * static_cast<size_t>(columns_) + static_cast<size_t>(j)];
    }

    // Which way the triangle below (or above) a cell's diagonal faces: 1, -1, or 0 where it has no area to
    // speak of.
    [[nodiscard]] int facing(int i, int j, bool above) const
    {
        const Vec4& a = at(i, j);
        const Vec4& b = above ? at(i + 1, j + 1) : at(i + 1, j);
        const Vec4& c = above ? at(i, j + 1) : at(i + 1, j + 1);
        const Vec3 p(a.x, a.y, a.w);
        const Vec3 q = Vec3(b.x, b.y, b.w) - p;
        const Vec3 r = Vec3(c.x, c.y, c.w) - p;
        const Vec3 normal = glm::cross(q, r);
        const double volume = glm::dot(p, normal);
        constexpr double kRounding = 1e-13;  // of a corner
        if (std::abs(volume) <= kRounding * glm::dot(p, p) * std::max(glm::length(q), glm::length(r)))
            return 0;
        return volume > 0 ? 1 : -1;
    }

    // The edges of a cell across which the surface turns from facing the eye to facing away.
    void paintFolds(PixelPainter& painter, int i, int j) const
    {
        const int below = facing(i, j, false);
        const int above = facing(i, j, true);
        if (below * above < 0)
            painter.keepOff(at(i, j), at(i + 1, j + 1));
        if (i > 0 && facing(i - 1, j, false) * above < 0)
            painter.keepOff(at(i, j), at(i, j + 1));
        if (j > 0 && facing(i, j - 1, true) * below < 0)
            painter.keepOff(at(i, j), at(i + 1, j));
    }

    struct Place {
        int i = 0;
        int j = 0;
    };

    // A contour that arrives at the surface's border goes on from another vertex of the neighbour's mesh,
    // along the border for an edge or so. `step` leads along the border; `above` says which triangles touch
    // it.
    void paintBorderFold(PixelPainter& painter, Place from, Place step, bool above) const
    {
        const int i = std::min(from.i, rows_ - 2);
        const int j = std::min(from.j, columns_ - 2);
        if (facing(i, j, above) * facing(i + step.i, j + step.j, above) >= 0)
            return;
        const Vec4& middle = at(from.i + step.i, from.j + step.j);
        painter.keepOff(at(from.i, from.j), middle);
        painter.keepOff(middle, at(from.i + 2 * step.i, from.j + 2 * step.j));
    }

    int rows_ = 0;
    int columns_ = 0;
    std::vector<Vec4> points_;
};

}  // namespace

size_t PixelMask::count() const
{
    return static_cast<size_t>(std::count(covered.begin(), covered.end(), std::uint8_t{1}));
}

PixelMask silhouetteMask(std::span<const SurfaceInClip> surfaces, int width, int height, double tolerancePx)
{
    PixelPainter painter(width, height, std::ceil(tolerancePx) + 1.0);
    for (const SurfaceInClip& surface : surfaces)
        SurfaceMesh(surface.surface, surface.toClip, width, height).paint(painter);
    return painter.mask();
}

}  // namespace knotspan
