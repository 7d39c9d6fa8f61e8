// Bodies whose edges lie on each other, such as the parts of an assembly: found again, so that each can be
// welded by itself. Nothing in a model says which faces belong together, but what is joined by an edge that
// only two have does.
#pragma once

#include "model/mesh/outline_weld.h"

namespace knotspan {

// By face: numbers from 0 on, as few as there can be so that bodies which share an edge have different ones.
// All 0 where there are none, or where more than two faces of a body meet.
[[nodiscard]] std::vector<std::uint32_t> touchingBodies(std::uint32_t faces, const OutlineWeld& weld);

}  // namespace knotspan
