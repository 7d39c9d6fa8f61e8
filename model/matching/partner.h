// The other surface along an edge, seen in the parameters of the surface that is to move, and the row of
// control points that both can share.
#pragma once

#include <functional>

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

// The part [from, to] of the edge v of `other` (its edge lies at u = start), its v mapped to the domain of
// `along`, turned round where `reversed`. Its knots that are nearly knots of `along` become them. Fails where
// knots fall together.
[[nodiscard]] Result<NurbsSurface> partnerOf(const NurbsSurface& other, double from, double to, bool reversed,
                                             const KnotVector& along);

// Both with the same degree and knots along v, no higher and no more than needed.
struct SameEdgeKnots {
    NurbsSurface mover;
    NurbsSurface partner;
};
[[nodiscard]] SameEdgeKnots withSameEdgeKnots(const NurbsSurface& mover, const NurbsSurface& partner);

// Which knots to insert into `have` so that it has each inner knot of `wanted` (of the same degree).
[[nodiscard]] std::vector<double> missingKnots(const KnotVector& have, const KnotVector& wanted);

// Which parameter of the partner's edge goes with v of the mover's.
using Partnering = std::function<double(double v)>;
// v itself.
[[nodiscard]] Partnering sameParameter();
// The nearest point of the partner's edge. Remembers what it was asked, copies of it share that: not for
// several threads.
[[nodiscard]] Partnering nearestParameter(const NurbsSurface& mover, const NurbsSurface& partner);

// The largest distance between the edges, at `perSpan` points a span of the mover's.
[[nodiscard]] double measuredGap(const NurbsSurface& mover, const NurbsSurface& partner,
                                 const Partnering& partnering, int perSpan);

}  // namespace knotspan
