// How many others lie along a border side: whether it is open, closed by one neighbour, or shared by more.
#pragma once

#include "model/analysis/coincident_edges.h"

namespace knotspan {

// Of the parts into which the ends of others cut a side: the least and the most others along one.
struct BorderCover {
    std::uint32_t least = 0;
    std::uint32_t most = 0;
};
[[nodiscard]] BorderCover coverOf(const CoincidentEdges& edges, std::uint32_t side);

// A pole, or others run along its whole length.
[[nodiscard]] bool isClosedSide(const CoincidentEdges& edges, std::uint32_t side);

// A pole, or each part of it has exactly one other along it, as on the surface of a body.
[[nodiscard]] bool isManifoldSide(const CoincidentEdges& edges, std::uint32_t side);

}  // namespace knotspan
