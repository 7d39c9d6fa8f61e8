#include "tests/model/analysis/measured_error.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan::testing {

namespace {

double distanceAt(const Vec4& drawn, const Vec4& exact, const ScreenView& view)
{
    if (!(drawn.w > 0) || !(drawn.z <= drawn.w))
        return 0;
    const Vec2 shown = Vec2(drawn) / drawn.w;
    if (shown.x < view.low.x || shown.y < view.low.y || shown.x > view.high.x || shown.y > view.high.y)
        return 0;
    if (!(exact.w > 0))
        return std::numeric_limits<double>::infinity();
    return glm::length(shown - Vec2(exact) / exact.w);
}

// Bernstein polynomials of `degree` at k / steps for k = 0 .. steps.
std::vector<double> bernstein(int degree, int steps)
{
    std::vector<double> rows;
    for (int k = 0; k <= steps; ++k) {
        const double t = static_cast<double>(k) / steps;
        std::vector<double> row{1.0};
        for (int d = 1; d <= degree; ++d) {
            row.push_back(0);
            for (int r = d; r >= 0; --r)
                row[static_cast<size_t>(r)] = (r < d ? (1 - t) * row[static_cast<size_t>(r)] : 0) +
                                              (r > 0 ? t * row[static_cast<size_t>(r) - 1] : 0);
        }
        rows.insert(rows.end(), row.begin(), row.end());
    }
    return rows;
}

// The surface at (k / stepsU, l / stepsV).
class Lattice {
public:
    Lattice(const BezierNet& net, int stepsU, int stepsV)
        : net_(net),
          stepsV_(stepsV),
          basisU_(bernstein(net.degreeU, stepsU)),
          basisV_(bernstein(net.degreeV, stepsV))
    {
    }

    // Row k: all l.
    [[nodiscard]] std::vector<Vec4> row(int k) const
    {
        const int p = net_.degreeU;
        const int q = net_.degreeV;
        std::vector<Vec4> curve(static_cast<size_t>(q) + 1, Vec4(0));
        for (int i = 0; i <= p; ++i)
            for (int j = 0; j <= q; ++j)
                curve[static_cast<size_t>(j)] +=
                    basisU_[static_cast<size_t>(k * (p + 1) + i)] * net_.at(i, j);
        std::vector<Vec4> result(static_cast<size_t>(stepsV_) + 1, Vec4(0));
        for (int l = 0; l <= stepsV_; ++l)
            for (int j = 0; j <= q; ++j)
                result[static_cast<size_t>(l)] +=
                    basisV_[static_cast<size_t>(l * (q + 1) + j)] * curve[static_cast<size_t>(j)];
        return result;
    }

private:
    const BezierNet& net_;
    int stepsV_;
    std::vector<double> basisU_;
    std::vector<double> basisV_;
};

// Over a cell with these corners, at x, y in [0, 1] x [0, 1].
Vec4 drawnPoint(const Vec4& c00, const Vec4& c10, const Vec4& c01, const Vec4& c11, bool rising, double x,
                double y)
{
    if (rising)
        return x >= y ? (1 - x) * c00 + (x - y) * c10 + y * c11 : (1 - y) * c00 + (y - x) * c01 + x * c11;
    return x + y <= 1 ? (1 - x - y) * c00 + x * c10 + y * c01
                      : (x + y - 1) * c11 + (1 - y) * c10 + (1 - x) * c01;
}

}  // namespace

double measuredError(const BezierNet& pixels, const ScreenView& view, const Grid& grid, bool rising,
                     int samples, double enough)
{
    const Lattice lattice(pixels, grid.u * samples, grid.v * samples);
    double largest = 0;
    std::vector<std::vector<Vec4>> rows{lattice.row(0)};
    for (int i = 0; i < grid.u; ++i) {
        rows = {rows.back()};
        for (int k = 1; k <= samples; ++k)
            rows.push_back(lattice.row(i * samples + k));
        for (int j = 0; j < grid.v; ++j) {
            const auto at = [&](int k, int l) {
                return rows[static_cast<size_t>(k)][static_cast<size_t>(j * samples + l)];
            };
            for (int k = 0; k <= samples; ++k)
                for (int l = 0; l <= samples; ++l) {
                    const Vec4 drawn =
                        drawnPoint(at(0, 0), at(samples, 0), at(0, samples), at(samples, samples), rising,
                                   static_cast<double>(k) / samples, static_cast<double>(l) / samples);
                    largest = std::max(largest, distanceAt(drawn, at(k, l), view));
                }
            if (largest > enough)
                return largest;
        }
    }
    return largest;
}

double measuredError(const BezierNet& pixels, const ScreenView& view, const Vec2 (&corners)[3], int samples)
{
    Vec4 vertices[3];
    for (int k = 0; k < 3; ++k)
        vertices[k] = evaluate(pixels, corners[k].x, corners[k].y);
    double largest = 0;
    for (int k = 0; k <= samples; ++k)
        for (int l = 0; k + l <= samples; ++l) {
            const double a = static_cast<double>(k) / samples;
            const double b = static_cast<double>(l) / samples;
            const Vec2 at = (1 - a - b) * corners[0] + a * corners[1] + b * corners[2];
            const Vec4 drawn = (1 - a - b) * vertices[0] + a * vertices[1] + b * vertices[2];
            largest = std::max(largest, distanceAt(drawn, evaluate(pixels, at.x, at.y), view));
        }
    return largest;
}

std::optional<Grid> smallestMeasuredGrid(const BezierNet& pixels, const ScreenView& view, double tolerance,
                                         bool rising, long cells)
{
    for (int count = 1; count <= cells; ++count)
        for (int u = 1; u <= count; ++u) {
            const Grid grid{u, count / u};
            if (grid.cells() != count)
                continue;
            const int samples = std::max(4, 16 / std::max(grid.u, grid.v));
            if (measuredError(pixels, view, grid, rising, samples, tolerance) <= tolerance)
                return grid;
        }
    return std::nullopt;
}

}  // namespace knotspan::testing
