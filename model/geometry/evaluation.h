// The double reference evaluation of a surface: what every other evaluator, on CPU and GPU, is measured
// against.
#pragma once

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

// A point of a surface with its derivatives, in model units per unit of the parameters.
struct SurfacePoint {
    Vec3 position{};
    Vec3 du{};
    Vec3 dv{};
    Vec3 duu{};
    Vec3 duv{};
    Vec3 dvv{};
};

// At (u, v); parameters outside the domain are taken to its border (NaN to its start), interior knots belong
// to the span on their right. The NURBS Book, A4.4, on coordinates relative to the point itself, so that
// neither a place far from the origin nor short spans or uneven weights cost digits. All figures are finite;
// a derivative beyond the range of double is 0.
[[nodiscard]] SurfacePoint evaluate(const NurbsSurface& surface, double u, double v);

// A unit normal, S_u x S_v normalised. Where that vanishes (a pole, coincident control points) the limit
// approached from inside the patch; where even that does not exist (`exists` is false), some unit vector,
// never NaN.
struct SurfaceNormal {
    Vec3 direction{0, 0, 1};
    bool isLimit = false;
    bool exists = true;
};
[[nodiscard]] SurfaceNormal evaluateNormal(const NurbsSurface& surface, double u, double v);

}  // namespace knotspan
