// Names for edges of surfaces and parts of them.
#pragma once

#include <optional>

#include "model/analysis/border_curves.h"

namespace knotspan {

// Which curve of a surface's trim loops.
struct TrimPlace {
    std::uint32_t loop = 0;
    std::uint32_t curve = 0;
    [[nodiscard]] bool operator==(const TrimPlace&) const = default;
};

// A part of one edge of a surface: between two parameters, from < to, of the surface along `side`, or of the
// trim curve.
struct EdgePart {
    std::uint32_t surface = 0;
    Side side = Side::startU;
    double from = 0;
    double to = 0;
    std::optional<TrimPlace> trim = {};  // then `side` says nothing
    [[nodiscard]] bool operator==(const EdgePart&) const = default;
    [[nodiscard]] bool isOnSameEdge(const EdgePart& other) const
    {
        return surface == other.surface && trim == other.trim && (trim || side == other.side);
    }
};

}  // namespace knotspan
