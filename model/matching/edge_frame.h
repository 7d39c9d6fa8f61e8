// How a surface lies at a point of its edge: tangent plane and curvatures, in a frame that both surfaces
// along the edge can be compared in.
#pragma once

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

struct EdgeFrame {
    Vec3 point{};
    Vec3 along{};   // unit, the way v grows
    Vec3 across{};  // unit, tangent to the surface, at right angles to `along`
    Vec3 normal{};  // along x across
    // The second fundamental form by `normal`: curvatures, 1/unit.
    double alongAlong = 0;
    double alongAcross = 0;
    double acrossAcross = 0;
    bool regular = false;  // otherwise there is no tangent plane, and only the point counts
};

// Of the edge u = start at v; `across` leads into the surface.
[[nodiscard]] EdgeFrame frameInto(const NurbsSurface& edgeFirst, double v);

// The frame for the surface beyond the edge, which it has too where both are smooth there: `across` and
// `normal` turned over.
[[nodiscard]] EdgeFrame turned(const EdgeFrame& frame);

// Between the tangent planes of two surfaces whose frames lead into the same side, in degrees: 180 where one
// folds back on the other or a frame is not regular.
[[nodiscard]] double breakDeg(const EdgeFrame& first, const EdgeFrame& second);

}  // namespace knotspan
