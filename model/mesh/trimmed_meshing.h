// Surfaces of which some are trimmed as one welded mesh: tessellation.h's way for those.
#pragma once

#include "model/mesh/tessellation.h"
#include "model/trimming/trim_region.h"

namespace knotspan {

struct PlacedScene {
    std::vector<PlacedSurface> surfaces;  // with their loops
    std::vector<ObjectId> objects;
    std::vector<std::string> names;
};

// 1 for surfaces that are trimmed, or joined to one that is, or to one that is joined to it ...
[[nodiscard]] std::vector<std::uint32_t> reachedByTrimming(const PlacedScene& placed,
                                                           const TessellationOptions& options);

// Bodies that touch are welded each by itself.
[[nodiscard]] Result<Tessellation> tessellateTrimmed(const PlacedScene& placed,
                                                     const TessellationOptions& options);

}  // namespace knotspan
