#include "model/mesh/mesh_limits.h"

#include <cstdio>

namespace knotspan {

std::string shortText(double number)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", number);
    return text;
}

Result<void> isNotTooFine(const CellCounts& counts, size_t mostTriangles)
{
    double triangles = 0;
    for (const Grid& grid : counts.grids)
        triangles += 2.0 * static_cast<double>(grid.cells());
    if (!counts.failed.empty())
        return failure("A mesh this fine would need more than " + std::to_string(kLargestFactor) +
                           " cells along a side of a knot span",
                       "Choose a larger deviation");
    if (triangles > static_cast<double>(mostTriangles))
        return failure("A mesh this fine would have about " + shortText(triangles) + " triangles",
                       "Choose a larger deviation");
    return {};
}

}  // namespace knotspan
