// How far one surface is from another that has the same parameters.
#pragma once

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

struct Deviation {
    double measured = 0;  // the largest distance found at many (u, v)
    double bound = 0;     // no point is further from the other surface's at the same (u, v)
};

// Both over the same domain. The bound comes from control points over the knots of both, each span in
// quarters; the more weights vary within a span, the further it is above the truth.
[[nodiscard]] Deviation deviationOf(const NurbsSurface& a, const NurbsSurface& b);

}  // namespace knotspan
