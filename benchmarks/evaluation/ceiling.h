// How fast one core computes and writes when nothing else holds it up: what evaluation is measured by.
#pragma once

#include <cstddef>

namespace knotspan::benchmarks {

// The number of multiply-adds done, in double. `sum` is only there so that they are needed.
double multiplyAdds(size_t rounds, double factor, double term, double& sum);

// Writes without fetching what was there. `memory` is aligned to 64 bytes.
void fillPastTheCache(double* memory, size_t count, double value);

}  // namespace knotspan::benchmarks
