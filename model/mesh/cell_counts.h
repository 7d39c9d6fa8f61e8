// How many cells each KSQuad of placed surfaces needs on its own, before neighbours are heard.
#pragma once

#include <optional>

#include "model/analysis/border_curves.h"
#include "model/mesh/space_error.h"

namespace knotspan {

struct CellCounts {
    // By KSQuad, as BorderNumbers counts them.
    std::vector<Grid> grids;
    std::vector<double> bounds;         // of triangles no larger than those cells, in model units
    std::vector<char> rising;           // cells are better cut from (0, 0) to (1, 1)
    std::vector<std::uint32_t> failed;  // KSQuads that would need more than kLargestFactor cells along a side
};

// What of KSQuads is asked for besides, for triangles of any shape.
struct KsQuadShapes {
    std::vector<SpaceWindow> whole;
    std::vector<Vec2> speeds;  // no point moves faster in space, by each parameter of the KSQuad
};

// Within `deviations` > 0 of each surface; with an angle normals turn no more than about so far across a
// cell, which is sampled, not proved.
[[nodiscard]] CellCounts cellCounts(const std::vector<PlacedSurface>& surfaces,
                                    const std::vector<double>& deviations, std::optional<double> angleDegrees,
                                    KsQuadShapes* shapes = nullptr);

}  // namespace knotspan
