// Gauss's rules of integration on [0, 1], in pairs: what two of them differ by is an estimate of the error.
#pragma once

#include <vector>

namespace knotspan {

struct GaussRule {
    std::vector<double> places;
    std::vector<double> weights;
};

[[nodiscard]] const GaussRule& coarseGauss();  // of 5 points
[[nodiscard]] const GaussRule& fineGauss();    // of 8
[[nodiscard]] const GaussRule& narrowGauss();  // of 12

}  // namespace knotspan
