// The basis functions of one direction at many parameters: for each span a table of numbers, made once, from
// which values and the rows that derivatives are made of come without a division.
//
// A table is the 2p normalised knot differences of shaders/shared/triangular_basis.glsl, then the reciprocals
// of the recursion's denominators in the order in which it takes them.
#pragma once

#include <span>

#include "model/geometry/basis_kernels.h"
#include "model/geometry/span_numbers.h"
#include "model/geometry/span_parameter.h"

namespace knotspan {

class SpanTables {
public:
    explicit SpanTables(const KnotVector& knots);

    [[nodiscard]] int degree() const { return degree_; }

    // The functions at the first eight of the parameters, or at as many as there are: lanes.rows[b][k][l] at
    // the l-th. Row b holds those of degree p - b that are not zero on the span, b = 0 .. order <= 2 (none
    // beyond the degree). Spare lanes repeat the last parameter.
    void basis(std::span<const SpanParameter> at, int order, kernels::BasisLanes& lanes) const;

private:
    int degree_;
    SpanNumbers<double> tables_;
};

}  // namespace knotspan
