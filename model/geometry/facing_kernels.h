// The sums behind a FacingNet (model/analysis/facing.h), in the best instruction set of the machine.
#pragma once

#include <cstddef>

namespace knotspan::kernels {

// A homogeneous point times planes of numbers that lie `pitch` behind each other.
struct FacingTerm {
    double x = 0;
    double y = 0;
    double z = 0;
    double w = 0;
    const double* planes = nullptr;  // read from here on, a vector's length beyond `count`
};

// Written for whole vectors: this many numbers more than asked for may be read and written.
constexpr size_t kFacingPadding = 8;

// The sum of the terms' 2 x 2 determinants of rows (point; planes x, y, z, w): planes xy, xz, xw, yz, yw, zw.
void sumFacingMinors(const FacingTerm* terms, size_t termCount, size_t pitch, size_t count, double* minors);

// The sum of the vectors whose product with any e is the 4 x 4 determinant of rows (e; point; and the two of
// the minors), times `scales`: planes x, y, z, w.
void sumFacingProducts(const FacingTerm* terms, size_t termCount, size_t pitch, size_t count,
                       const double* scales, double* sums);

}  // namespace knotspan::kernels
