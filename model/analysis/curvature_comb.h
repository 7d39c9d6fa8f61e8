// Curvature combs: how iso-curves of a surface bend, as teeth along them.
//
// A tooth is the curvature vector of the iso-curve itself, as a curve in space: k N = (C'' - (C'' . T) T) /
// |C'|^2, with T the unit tangent and N the unit principal normal; its length k is 1 / radius of the
// osculating circle, and it points to that circle's centre. So it holds the bending within the surface, too
// (the geodesic curvature): a straight line on the surface has no teeth, a circle drawn on a plane does.
// Combs are drawn to the other side, out of the bend, as modellers are used to.
#pragma once

#include <vector>

#include "model/geometry/knot_insertion.h"
#include "model/geometry/nurbs_surface.h"
#include "model/geometry/trim_loop.h"

namespace knotspan {

struct CombTooth {
    Vec3 foot{0};       // on the curve; model space
    Vec3 curvature{0};  // 1 per model unit; zero where the curve has no tangent
};

// Along one iso-curve: `cells` + 1 teeth on each span of the other parameter, in order; at knots two, so that
// a jump of the curvature shows as one.
struct IsoComb {
    Direction across = Direction::U;  // the parameter that stands still
    double parameter = 0;
    std::vector<CombTooth> teeth;
};

// `count` iso-curves of each direction, evenly spread over the domain, its ends included; one: in the middle;
// below one: none. The surface as its affine transform places it. Of a trimmed one only the teeth that stand
// on what the loops leave: an iso-curve is then as many combs as it has parts of two teeth and more.
[[nodiscard]] std::vector<IsoComb> isoCombs(const NurbsSurface& surface, const Mat4& transform, int count,
                                            int cells, const std::vector<TrimLoop>& loops = {});

// The curvature that `part` (0 to 1) of the teeth that bend do not exceed; 1: the largest. 0 without any.
[[nodiscard]] double curvatureOfMost(const std::vector<IsoComb>& combs, double part);

}  // namespace knotspan
