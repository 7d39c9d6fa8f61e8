// The same surface told in another way: same points, other parameters, degrees, knots, control points.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/geometry/nurbs_surface.h"

namespace knotspan::testing {

// With u = scale u' + shift.
[[nodiscard]] NurbsSurface rescaledU(const NurbsSurface& surface, double scale, double shift);
// With u such that, over the domain, u' / (1 - u') of it is `factor` u / (1 - u): weights change, and speeds.
[[nodiscard]] NurbsSurface projectedU(const NurbsSurface& surface, double factor);

// Of one span and degree 2 along v, with v = 2 bend v' (1 - v') + v'^2, 0 < bend < 1: of degree 4.
[[nodiscard]] NurbsSurface unevenV(const NurbsSurface& surface, double bend);

struct Retelling {
    std::string name;
    std::function<NurbsSurface(const NurbsSurface&)> tell;
};
// The first one changes nothing.
[[nodiscard]] const std::vector<Retelling>& retellings();

}  // namespace knotspan::testing
