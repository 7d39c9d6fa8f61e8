#include "model/analysis/grid_choice.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/analysis/net_on_screen.h"
#include "model/core/check.h"

namespace knotspan {

namespace {

// How large the second derivatives look, part by part. No bound, since a cell may lie over several parts, and
// since parts may not be in front of the eye; but their relation is about that of the factors.
ErrorFigures estimatedFigures(const BezierNet& pixels, const ScreenView& view)
{
    ErrorFigures result;
    const auto [lower, upper] = split(pixels, Direction::U);
    for (const BezierNet* half : {&lower, &upper}) {
        const auto [first, second] = split(*half, Direction::V);
        for (const BezierNet* part : {&first, &second}) {
            const NetOnScreen on(*part, view);
            if (!on.visible)
                continue;
            const auto figure = [&](int orderU, int orderV) {
                double largest = 0;
                for (const Vec4& value : secondDerivatives(*part, orderU, orderV))
                    largest = std::max(largest, on.disc.largestSeen(value));
                return 4 * largest / std::max(on.nearest, 1e-300);
            };
            result.a = std::max(result.a, figure(2, 0));
            result.b = std::max(result.b, figure(1, 1));
            result.c = std::max(result.c, figure(0, 2));
        }
    }
    return result;
}

class Search {
public:
    Search(const BezierNet& pixels, const ScreenView& view, double tolerance, Triangles triangles,
           int largest, const ProofEffort& effort)
        : pixels_(pixels),
          view_(view),
          tolerance_(tolerance),
          triangles_(triangles),
          largest_(largest),
          effort_(effort)
    {
    }

    // The true figures are the estimated ones times a factor that changes little with the grid: it is found
    // from below, where proofs fail early, then between the last two.
    GridChoice best(const ErrorFigures& figures)
    {
        double fails = 1.0 / 16;
        double works = 2 * fails;
        std::optional<Grid> grid = candidate(figures, works);
        for (; grid && !holds(*grid); grid = candidate(figures, works)) {
            fails = works;
            works *= 2;
        }
        if (!grid) {
            grid = Grid{largest_, largest_};
            if (!holds(*grid))
                return {*grid, true, false};
            works = 2 * fails;
        }
        for (int step = 0; step < 3; ++step) {
            const double between = std::sqrt(works * fails);
            const auto tried = candidate(figures, between);
            if (tried && (*tried == *grid || (tried->cells() < grid->cells() && holds(*tried)))) {
                works = between;
                grid = tried;
            } else {
                fails = between;
            }
        }
        return {polished(*grid), true, true};
    }

    [[nodiscard]] bool holds(const Grid& grid) const
    {
        return keepsTolerance(pixels_, view_, grid, tolerance_, triangles_, effort_);
    }

private:
    [[nodiscard]] std::optional<Grid> candidate(const ErrorFigures& figures, double scale) const
    {
        return smallestGrid({scale * figures.a, scale * figures.b, scale * figures.c}, tolerance_, largest_);
    }

    // Steps to neighbours of fewer cells as long as one holds.
    [[nodiscard]] Grid polished(Grid grid) const
    {
        for (;;) {
            const std::array<Grid, 4> neighbours{
                Grid{grid.u - 1, grid.v - 1}, Grid{grid.u - 1, grid.v}, Grid{grid.u, grid.v - 1},
                grid.u > grid.v ? Grid{grid.u - 1, grid.v + 1} : Grid{grid.u + 1, grid.v - 1}};
            const auto better = std::find_if(neighbours.begin(), neighbours.end(), [&](const Grid& n) {
                return n.u > 0 && n.v > 0 && n.u <= largest_ && n.v <= largest_ && n.cells() < grid.cells() &&
                       holds(n);
            });
            if (better == neighbours.end())
                return grid;
            grid = *better;
        }
    }

    const BezierNet& pixels_;
    const ScreenView& view_;
    double tolerance_;
    Triangles triangles_;
    int largest_;
    ProofEffort effort_;
};

}  // namespace

GridChoice chooseGrid(const BezierNet& pixels, const ScreenView& view, double tolerance, Triangles triangles,
                      int largest, const ProofEffort& effort)
{
    check(tolerance > 0, "a tolerance is above zero");
    const NetOnScreen on(pixels, view);
    if (!on.visible)
        return {{1, 1}, false, true};
    Search search(pixels, view, tolerance, triangles, largest, effort);
    if (search.holds({1, 1}))
        return {{1, 1}, true, true};
    return search.best(estimatedFigures(pixels, view));
}

}  // namespace knotspan
