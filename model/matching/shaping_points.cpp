#include "model/matching/shaping_points.h"

#include <limits>

#include "model/matching/row_relation.h"

namespace knotspan {

namespace {

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] bool isReachedBy(const KnotVector& knots, int point) const
    {
        return knots[point] <= high && low <= knots[point + knots.degree() + 1];
    }
};

}  // namespace

std::vector<int> shapingPoints(const PlacedSurface& placed, const EdgePart& edge)
{
    const NurbsSurface& surface = *placed.surface;
    std::vector<int> result;
    if (!edge.trim) {
        const NetRows rows(surface, edge.side);
        for (const int row : {0, 1})
            for (int k = 0; k < rows.length(); ++k)
                result.push_back(rows.index(row, k));
        return result;
    }
    Range u;
    Range v;
    for (const TrimPoint& point : (*placed.trimLoops)[edge.trim->loop].curves[edge.trim->curve].points()) {
        u.add(point.position.x);
        v.add(point.position.y);
    }
    for (int i = 0; i < surface.countU(); ++i)
        for (int j = 0; j < surface.countV(); ++j)
            if (u.isReachedBy(surface.knotsU(), i) && v.isReachedBy(surface.knotsV(), j))
                result.push_back(i * surface.countV() + j);
    return result;
}

}  // namespace knotspan
