// Solves symmetric positive definite systems whose entries lie near the diagonal: the normal equations of
// curves fitted by few control points at a time.
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
    void addRight(int row, double value) { right_[static_cast<std::size_t>(row)] += value; }

    // The solution; nothing where the matrix is not positive definite. Cholesky, in place: call it once.
    [[nodiscard]] std::vector<double> solve();

private:
    [[nodiscard]] double& at(int row, int column);

    int size_;
    int band_;
    std::vector<double> entries_;  // row r: columns r - band .. r
    std::vector<double> right_;
};

}  // namespace knotspan
