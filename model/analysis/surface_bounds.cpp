#include "model/analysis/surface_bounds.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include <glm/common.hpp>

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

constexpr int kPointsPerSpan = 4;

std::vector<double> gridOf(const KnotVector& knots)
{
    std::vector<double> grid;
    for (const int span : knots.spans())
        for (int k = 0; k < kPointsPerSpan; ++k)
            grid.push_back(knots[span] + (knots[span + 1] - knots[span]) * k / kPointsPerSpan);
    grid.push_back(knots.domainEnd());
    return grid;
}

// The highest point seen so far along one axis, up or down, and where it is.
struct Summit {
    int axis;
    double sign;
    double height = -std::numeric_limits<double>::infinity();
    Vec2 at{};

    bool offer(const Vec3& point, const Vec2& where)
    {
        const double offered = sign * point[axis];
        if (!(offered > height))
            return false;
        height = offered;
        at = where;
        return true;
    }
};

// Looks to four sides at a distance that halves whenever none of them is higher.
void climb(Summit& summit, const NurbsSurface& surface, const Mat4& transform)
{
    const KnotVector& u = surface.knotsU();
    const KnotVector& v = surface.knotsV();
    const Vec2 low(u.domainStart(), v.domainStart());
    const Vec2 high(u.domainEnd(), v.domainEnd());
    const auto spans = Vec2(static_cast<double>(u.spans().size()), static_cast<double>(v.spans().size()));
    Vec2 step = (high - low) / (spans * double{kPointsPerSpan});
    constexpr int kHalvings = 24;  // the height goes with the square of the distance
    for (int halving = 0; halving < kHalvings;) {
        bool higher = false;
        for (const Vec2& side : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) {
            const Vec2 there = glm::clamp(summit.at + side * step, low, high);
            higher |=
                summit.offer(transformed(evaluate(surface, there.x, there.y).position, transform), there);
        }
        if (higher)
            continue;
        step *= 0.5;
        ++halving;
    }
}

}  // namespace

Box surfaceBounds(const NurbsSurface& surface, const Mat4& transform)
{
    std::array<Summit, 6> summits{{{0, 1}, {0, -1}, {1, 1}, {1, -1}, {2, 1}, {2, -1}}};
    const std::vector<double> gridV = gridOf(surface.knotsV());
    for (const double u : gridOf(surface.knotsU()))
        for (const double v : gridV) {
            const Vec3 point = transformed(evaluate(surface, u, v).position, transform);
            for (Summit& summit : summits)
                summit.offer(point, {u, v});
        }
    Box box;
    for (Summit& summit : summits) {
        climb(summit, surface, transform);
        box.add(transformed(evaluate(surface, summit.at.x, summit.at.y).position, transform));
    }
    return box;
}

}  // namespace knotspan
