#include "model/matching/banded_cholesky.h"

#include <algorithm>
#include <cmath>

namespace knotspan {

BandedSystem::BandedSystem(int size, int band)
    : size_(size),
      band_(std::min(band, size - 1)),
      entries_(static_cast<size_t>(size) * static_cast<size_t>(band_ + 1), 0.0),
      right_(static_cast<size_t>(size), 0.0)
{
}

double& BandedSystem::at(int row, int column)
{
    return entries_[static_cast<size_t>(row) * static_cast<size_t>(band_ + 1) +
                    static_cast<size_t>(column - row + band_)];
}

void BandedSystem::add(int row, int column, double value)
{
    if (row >= column)
        at(row, column) += value;
}

std::vector<double> BandedSystem::solve()
{
    for (int row = 0; row < size_; ++row)
        for (int column = std::max(0, row - band_); column <= row; ++column) {
            double sum = at(row, column);
            for (int k = std::max(0, row - band_); k < column; ++k)
                if (k >= column - band_)
                    sum -= at(row, k) * at(column, k);
            if (row != column)
                at(row, column) = sum / at(column, column);
            else if (sum > 0)
                at(row, row) = std::sqrt(sum);
            else
                return {};
        }
    std::vector<double> x = right_;
    for (int row = 0; row < size_; ++row) {
        for (int k = std::max(0, row - band_); k < row; ++k)
            x[static_cast<size_t>(row)] -= at(row, k) * x[static_cast<size_t>(k)];
        x[static_cast<size_t>(row)] /= at(row, row);
    }
    for (int row = size_ - 1; row >= 0; --row) {
        x[static_cast<size_t>(row)] /= at(row, row);
        for (int k = std::max(0, row - band_); k < row; ++k)
            x[static_cast<size_t>(k)] -= at(row, k) * x[static_cast<size_t>(row)];
    }
    return x;
}

}  // namespace knotspan
