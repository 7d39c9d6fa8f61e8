// The box of a surface itself, or of what trim loops leave of it; its control points' box
// (NurbsSurface::bounds) is larger, often much.
#pragma once

#include "model/core/space.h"
#include "model/geometry/nurbs_surface.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {

// The box around the transformed surface, to about 1e-9 of its size: in each of the six directions the best
// of a grid of four by four cells on each KSQuad whose control points reach that far, climbed from there. A
// bulge narrower than that grid may be missed, so this is for people; what must enclose the surface takes the
// control points.
[[nodiscard]] Box surfaceBounds(const NurbsSurface& surface, const Mat4& transform);

// The same of what the loops leave: with their curves' own extremes, looked for from eight places on each of
// their monotone pieces. Of the whole surface where the loops cannot be followed.
[[nodiscard]] Box trimmedBounds(const NurbsSurface& surface, const std::vector<TrimLoop>& loops,
                                const Mat4& transform);

}  // namespace knotspan
