// What a number of measurements comes to.
#pragma once

#include <vector>

namespace knotspan {

// One measurement has all three equal.
struct Spread {
    double min = 0;
    double median = 0;  // of an even number the mean of the two in the middle
    double max = 0;
};

// `values` holds at least one.
[[nodiscard]] Spread spreadOf(std::vector<double> values);

}  // namespace knotspan
