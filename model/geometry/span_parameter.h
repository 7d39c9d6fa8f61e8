// Places along one direction of a surface as evaluation counts them: by span.
#pragma once

#include <span>
#include <vector>

#include "model/geometry/knot_vector.h"

namespace knotspan {

// A span of non-zero length (KnotVector::spans()) and t in [0, 1] inside it. t = 1 is the end of this span,
// also where the next one begins with a crease.
struct SpanParameter {
    int span = 0;
    double t = 0;
};

// Of parameters u, taken to the domain's border where they lie outside; interior knots belong to the span on
// their right.
[[nodiscard]] std::vector<SpanParameter> spanParameters(const KnotVector& knots,
                                                        std::span<const double> values);
// `cells` equal cells on every span: cells + 1 parameters a span, from its start to its own end.
[[nodiscard]] std::vector<SpanParameter> parametersPerSpan(const KnotVector& knots, int cells);

}  // namespace knotspan
