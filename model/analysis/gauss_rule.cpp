#include "model/analysis/gauss_rule.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace knotspan {

namespace {

// Roots of Legendre's polynomial by Newton's method from Chebyshev's (Abramowitz and Stegun, 25.4.29).
GaussRule gauss(int count)
{
    GaussRule rule;
    for (int k = 0; k < count; ++k) {
        double x = std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5));
        double slope = 1;
        for (int round = 0; round < 50; ++round) {
            double before = 1;
            double now = x;
            for (int n = 2; n <= count; ++n) {
                const double next = ((2 * n - 1) * x * now - (n - 1) * before) / n;
                before = std::exchange(now, next);
            }
            slope = count * (x * now - before) / (x * x - 1);
            const double step = now / slope;
            x -= step;
            if (std::abs(step) < 1e-16)
                break;
        }
        rule.places.push_back(0.5 + 0.5 * x);
        rule.weights.push_back(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace

const GaussRule& coarseGauss()
{
    static const GaussRule kRule = gauss(5);
    return kRule;
}

const GaussRule& fineGauss()
{
    static const GaussRule kRule = gauss(8);
    return kRule;
}

const GaussRule& narrowGauss()
{
    static const GaussRule kRule = gauss(12);
    return kRule;
}

}  // namespace knotspan
