// The surfaces at which evaluation is hardest, by name, each with the bounds that hold there for the CPU's
// evaluators.
#pragma once

#include <string>
#include <vector>

#include "model/geometry/nurbs_surface.h"

namespace knotspan::testing {

// Errors, component by component. The local size is the largest coordinate, relative to the surface's own
// origin (the centre of its box), of the control points that shape the KSQuad.
struct ErrorBounds {
    double position;          // of the local size, in units of 2^-52 for double and of 2^-24 for float
    double derivative;        // of the KSQuad's largest first derivative in that direction
    double secondDerivative;  // of that of the KSQuad, or of the first ones per span
    double normal;            // of the effect of errors as large as the tangents, where no limit is needed
    double limit;             // radians
};

struct ExtremeSurface {
    std::string name;
    NurbsSurface surface;
    ErrorBounds reference{4, 1e-13, 1e-12, 2e-13, 1e-9};
    ErrorBounds fast{4, 1e-13, 1e-12, 2e-13, 1e-8};     // GridEvaluator<double>
    ErrorBounds fastFloat{16, 1e-5, 1e-5, 1e-5, 1e-6};  // GridEvaluator<float>
    bool onlyFinite = false;  // nothing else is told about its derivatives, nor about what float makes of it
    std::string reason;       // why a bound differs from the common ones; empty where none does
};

[[nodiscard]] const std::vector<ExtremeSurface>& extremeSurfaces();

}  // namespace knotspan::testing
