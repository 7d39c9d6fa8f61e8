// The area of what trim loops leave of a surface.
#pragma once

#include "model/analysis/surface_area.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {

// As surfaceArea(), of what the loops leave; of the whole surface where there are none, or none that can be
// followed. In KSQuads that loops cut the area is an integral along the loops' own pieces (Green's theorem),
// so that the curves are not approximated: Gauss's rules of 12 and 8 points along each piece and across to
// the KSQuad's side, halved until they differ by less than about 1e-9 of the whole. The error is that
// difference.
[[nodiscard]] Area trimmedArea(
    const NurbsSurface& surface, const std::vector<TrimLoop>& loops, const Mat4& transform,
    const std::function<bool()>& isOff = [] { return false; });

}  // namespace knotspan
