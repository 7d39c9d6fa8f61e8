#include "model/geometry/banded_system.h"

#include <algorithm>
#include <cmath>

namespace knotspan {

BandedSystem::BandedSystem(int size, int band)
    : size_(size),
      band_(std::max(0, std::min(band, size - 1))),
      entries_(static_cast<size_t>(size) * static_cast<size_t>(band_ + 1), 0.0)
{
}

size_t BandedSystem::index(int row, int column) const
{
    return static_cast<size_t>(row) * static_cast<size_t>(band_ + 1) +
           static_cast<size_t>(column - row + band_);
}

void BandedSystem::add(int row, int column, double value)
{
    if (row >= column)
        entries_[index(row, column)] += value;
}

bool BandedSystem::factor()
{
    for (int row = 0; row < size_; ++row)
        for (int column = std::max(0, row - band_); column <= row; ++column) {
            double sum = entries_[index(row, column)];
            for (int k = std::max({0, row - band_, column - band_}); k < column; ++k)
                sum -= entries_[index(row, k)] * entries_[index(column, k)];
            if (row != column)
                sum /= entries_[index(column, column)];
            else if (sum > 0)
                sum = std::sqrt(sum);
            else
                return false;
            entries_[index(row, column)] = sum;
        }
    return true;
}

std::vector<double> BandedSystem::solve(std::vector<double> x) const
{
    for (int row = 0; row < size_; ++row) {
        double& value = x[static_cast<size_t>(row)];
        for (int k = std::max(0, row - band_); k < row; ++k)
            value -= entries_[index(row, k)] * x[static_cast<size_t>(k)];
        value /= entries_[index(row, row)];
    }
    for (int row = size_ - 1; row >= 0; --row) {
        const double value = x[static_cast<size_t>(row)] /= entries_[index(row, row)];
        for (int k = std::max(0, row - band_); k < row; ++k)
            x[static_cast<size_t>(k)] -= entries_[index(row, k)] * value;
    }
    return x;
}

}  // namespace knotspan
