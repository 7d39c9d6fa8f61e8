// A number at every point of some objects' surfaces, known on grids over their KSQuads and interpolated
// between.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "model/core/space.h"
#include "model/scene/scene.h"

namespace knotspan {

// Of one surface. By KSQuad, in the order of ksQuads(): how many cells its grid has each way and where its
// (cells + 1)^2 values start, u outer, v inner, evenly spaced.
struct GridNumbers {
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> first;
    std::vector<float> values;

    // Bilinear in the KSQuad's own parameters, 0 to 1 each; what lies beyond is taken to the border.
    [[nodiscard]] double at(size_t ksquad, const Vec2& t) const;
};

using SurfaceNumbers = std::map<ObjectId, GridNumbers>;
// Equal where it is the same one.
using SharedSurfaceNumbers = std::shared_ptr<const SurfaceNumbers>;

}  // namespace knotspan
