#include "model/core/spread.h"

#include <algorithm>

#include "model/core/check.h"

namespace knotspan {

Spread spreadOf(std::vector<double> values)
{
    check(!values.empty(), "there is a measurement");
    std::sort(values.begin(), values.end());
    const size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[middle] : 0.5 * values[middle - 1] + 0.5 * values[middle];
    return {values.front(), median, values.back()};
}

}  // namespace knotspan
