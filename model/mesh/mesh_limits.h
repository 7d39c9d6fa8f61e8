// Whether a mesh would be larger than anybody wants it.
#pragma once

#include "model/core/result.h"
#include "model/mesh/cell_counts.h"

namespace knotspan {

[[nodiscard]] Result<void> isNotTooFine(const CellCounts& counts, size_t mostTriangles);
[[nodiscard]] std::string shortText(double number);

}  // namespace knotspan
