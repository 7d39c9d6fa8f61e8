// The fewest cells for which the bound of space_error.h holds.
#include "model/mesh/space_error.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace knotspan {

namespace {

double largestBound(const std::vector<SpaceWindow>& windows, const Grid& grid)
{
    double largest = 0;
    for (const SpaceWindow& window : windows)
        largest = std::max(largest, window.errorBound(grid));
    return largest;
}

bool holds(const std::vector<SpaceWindow>& windows, const Grid& grid, double tolerance)
{
    return std::all_of(windows.begin(), windows.end(),
                       [&](const SpaceWindow& window) { return window.isWithin(tolerance, grid); });
}

// No coarser than `least`: the best of some candidates of the closed form, then of their neighbours.
std::optional<Grid> fewestCells(const std::vector<SpaceWindow>& windows, double tolerance, const Grid& least,
                                int largest)
{
    Vec3 figures(0);
    for (const SpaceWindow& window : windows)
        figures = glm::max(figures, window.better().largest / window.better().divisor);
    const auto candidate = [&](double scale) {
        auto grid =
            smallestGrid({scale * figures.x, scale * figures.y, scale * figures.z}, tolerance, largest);
        if (grid)
            grid = Grid{std::max(grid->u, least.u), std::max(grid->v, least.v)};
        return grid;
    };
    std::optional<Grid> best = candidate(1);
    if (!best || !holds(windows, *best, tolerance))
        return std::nullopt;
    double fails = 0.25;
    double works = 1;
    for (int step = 0; step < 5 && best->cells() > 1; ++step) {
        const double between = std::sqrt(fails * works);
        const auto tried = candidate(between);
        if (tried &&
            (*tried == *best || (tried->cells() <= best->cells() && holds(windows, *tried, tolerance)))) {
            works = between;
            best = tried;
        } else {
            fails = between;
        }
    }
    for (bool better = true; better;) {
        better = false;
        for (const Grid& next :
             {Grid{best->u - 1, best->v - 1}, Grid{best->u - 1, best->v}, Grid{best->u, best->v - 1},
              Grid{best->u - 1, best->v + 1}, Grid{best->u + 1, best->v - 1}}) {
            if (next.u < least.u || next.v < least.v || next.u > largest || next.v > largest ||
                next.cells() >= best->cells() || !holds(windows, next, tolerance))
                continue;
            best = next;
            better = true;
            break;
        }
    }
    return best;
}

constexpr long kFewCells = 12;  // looking again would cost more than it saves

}  // namespace

std::optional<SpaceGrid> chooseSpaceGrid(SpaceError& error, double tolerance, int largest)
{
    if (const double bound = error.whole().errorBound(Grid{1, 1}); bound <= tolerance)
        return SpaceGrid{{1, 1}, bound};
    error.considerSurface();
    std::vector<SpaceWindow> windows{error.whole()};
    std::optional<SpaceGrid> chosen;
    Grid least{1, 1};
    if (const auto grid = fewestCells(windows, tolerance, least, largest))
        chosen = SpaceGrid{*grid, largestBound(windows, *grid)};
    for (int round = 0; round < 3; ++round) {
        if (round > 0 && chosen && chosen->grid.cells() < kFewCells)
            break;
        // The windows say so for grids no coarser than theirs; the answer is about two thirds of the last
        // one.
        const Grid from = chosen ? chosen->grid : Grid{std::min(largest, 384), std::min(largest, 384)};
        const Grid next{std::max(1, 2 * from.u / 3), std::max(1, 2 * from.v / 3)};
        if (next.cells() == 1 || next == least)
            break;
        least = next;
        const int most = from.cells() > 64 ? 8 : 4;
        windows = error.windows(least, std::min(least.u, most), std::min(least.v, most));
        const auto grid = fewestCells(windows, tolerance, least, largest);
        if (!grid || (chosen && grid->cells() >= chosen->grid.cells()))
            break;
        chosen = SpaceGrid{*grid, largestBound(windows, *grid)};
    }
    return chosen;
}

}  // namespace knotspan
