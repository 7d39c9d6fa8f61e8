// KSQuads: the rectangles of non-zero area between neighbouring knots, the units that are culled and drawn.
//
// A KSQuad is an index into its surface, never a copy: the (p+1)(q+1) control points B_{i-p..i, j-q..j} alone
// shape it. Concheiro, Amor, Padron, Doggett, CAD 56 (2014).
#pragma once

#include <vector>

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

struct KsQuad {
    int spanU = 0;  // i: u in [U_i, U_{i+1})
    int spanV = 0;  // j: v in [V_j, V_{j+1})
};

// All KSQuads of a surface, u outer, v inner.
[[nodiscard]] std::vector<KsQuad> ksQuads(const NurbsSurface& surface);
[[nodiscard]] size_t ksQuadCount(const NurbsSurface& surface);

}  // namespace knotspan
