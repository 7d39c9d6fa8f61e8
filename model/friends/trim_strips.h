// The trim curves of a placed surface as edges: what is left of edge_strip.h once curves are put into the
// surface.
#pragma once

#include "model/friends/edge_strip.h"

namespace knotspan {

// One for each trim curve, in the order of loops and curves; the face lies to the left of every curve. Their
// surface's number, size, reach and box are left open. No piece is further from its curve than `deviation`,
// and normals along it are the surface's own.
[[nodiscard]] std::vector<EdgeStrip> trimStrips(const PlacedSurface& placed, double deviation);

}  // namespace knotspan
