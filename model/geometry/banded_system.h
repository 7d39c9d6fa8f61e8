// Symmetric positive definite systems whose entries lie near the diagonal: the normal equations of curves
// fitted by few control points at a time.
#pragma once

#include <cstddef>
#include <vector>

namespace knotspan {

class BandedSystem {
public:
    // Entries further than `band` from the diagonal are 0.
    BandedSystem(int size, int band);

    // Adds to the entry (row, column); only row >= column counts.
    void add(int row, int column, double value);

    // Cholesky, in place; false where the matrix is not positive definite. Once, before solve().
    [[nodiscard]] bool factor();
    [[nodiscard]] std::vector<double> solve(std::vector<double> right) const;

private:
    [[nodiscard]] size_t index(int row, int column) const;

    int size_;
    int band_;
    std::vector<double> entries_;  // row r: columns r - band .. r
};

}  // namespace knotspan
