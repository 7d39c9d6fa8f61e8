// Which control points an edge and the tangent planes along it hang on.
#pragma once

#include "model/friends/edge_part.h"

namespace knotspan {

// Indices into controlPoints(): the first two rows behind a whole side; for a trim curve, those whose basis
// functions reach into the box around its control points.
[[nodiscard]] std::vector<int> shapingPoints(const PlacedSurface& placed, const EdgePart& edge);

}  // namespace knotspan
