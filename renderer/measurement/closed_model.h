// Whether a model encloses a space, so that background seen through it is a leak.
#pragma once

#include "model/scene/scene.h"

namespace knotspan {

// True where the visible surfaces leave no border open: each side of a KSQuad that is its surface's border is
// a pole, or runs along others over its whole length (model/analysis/coincident_edges.h).
// Trimmed surfaces may have holes.
[[nodiscard]] bool isClosedModel(const Scene& scene);

}  // namespace knotspan
