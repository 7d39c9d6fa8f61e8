// The sums behind a BezierDecomposition, in the best instruction set of the machine.
#pragma once

#include <cstddef>

namespace knotspan::kernels {

// The matrices of one direction, a span's behind the other.
struct SpanSums {
    size_t order = 0;  // degree + 1
    size_t spans = 0;
    const double* matrices = nullptr;  // order rows of order numbers a span
    const size_t* firsts = nullptr;    // the first point that shapes the span
    size_t points = 0;
};

// `points`: alongU.points rows of alongV.points homogeneous points, 4 numbers each. `rows`: room for
// alongU.points * alongV.spans * alongV.order of them. `nets`: KSQuads u outer, v inner; nets likewise.
void decompose(const SpanSums& alongU, const SpanSums& alongV, const double* points, double* rows,
               float* nets);

}  // namespace knotspan::kernels
