// Parts of curves and surfaces as OBJ files state them: by numbers that a program has rounded, of nets that a
// stranger may have made.
#pragma once

#include "model/geometry/nurbs_surface.h"
#include "model/geometry/trim_loop.h"

namespace knotspan::formats {

struct ObjRange {
    double start = 0;
    double end = 1;
};

// The range inside the knots' domain: what is at its ends but for rounding is at its ends. Refuses one that
// is empty or leaves the domain.
[[nodiscard]] Result<ObjRange> rangeIn(const KnotVector& knots, ObjRange asked);

// The part, exactly; the whole as it is where that is meant. Refuses numbers so extreme that cutting would
// lose them.
[[nodiscard]] Result<NurbsSurface> partOf(const NurbsSurface& surface, ObjRange u, ObjRange v);
[[nodiscard]] Result<TrimCurve> partOf(const TrimCurve& curve, ObjRange range);

}  // namespace knotspan::formats
