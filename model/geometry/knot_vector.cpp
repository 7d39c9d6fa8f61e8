#include "model/geometry/knot_vector.h"

#include <algorithm>
#include <cmath>

#include "model/core/check.h"

namespace knotspan {

namespace {

Result<void> requireIncreasing(const std::vector<double>& knots)
{
    for (size_t i = 0; i < knots.size(); ++i) {
        if (!std::isfinite(knots[i]))
            return failure("Knot " + std::to_string(i) + " is not a finite number");
        if (i > 0 && knots[i] < knots[i - 1])
            return failure("Knot " + std::to_string(i) + " is smaller than the one before it");
    }
    if (!std::isfinite(knots.back() - knots.front()))
        return failure("The knots reach further than a number can tell");
    return {};
}

Result<void> requireMultiplicities(int degree, const std::vector<double>& knots)
{
    for (size_t first = 0, next = 0; first < knots.size(); first = next) {
        while (next < knots.size() && knots[next] == knots[first])
            ++next;
        const bool atEnd = first == 0 || next == knots.size();
        const size_t allowed = static_cast<size_t>(degree) + (atEnd ? 1 : 0);
        if (next - first > allowed)
            return failure("Knot " + std::to_string(first) + " stands there " + std::to_string(next - first) +
                           " times, but degree " + std::to_string(degree) + " allows " +
                           std::to_string(allowed) + (atEnd ? " at an end" : " inside"));
    }
    return {};
}

}  // namespace

Result<KnotVector> KnotVector::create(int degree, std::vector<double> knots)
{
    if (degree < kMinDegree || degree > kMaxDegree)
        return failure("Degree " + std::to_string(degree) + " is not between " + std::to_string(kMinDegree) +
                       " and " + std::to_string(kMaxDegree));
    const size_t fewest = 2 * (static_cast<size_t>(degree) + 1);
    if (knots.size() < fewest)
        return failure("Degree " + std::to_string(degree) + " needs at least " + std::to_string(fewest) +
                       " knots, but there are " + std::to_string(knots.size()));
    if (knots.size() > 100'000'000)
        return failure("There are more than 100 million knots");
    if (auto increasing = requireIncreasing(knots); !increasing)
        return tl::unexpected(increasing.error());
    const size_t domainEnd = knots.size() - static_cast<size_t>(degree) - 1;
    if (!(knots[static_cast<size_t>(degree)] < knots[domainEnd]))
        return failure("The knots leave the surface no length: its first and last parameter are the same");
    if (auto multiplicities = requireMultiplicities(degree, knots); !multiplicities)
        return tl::unexpected(multiplicities.error());
    return KnotVector(degree, std::move(knots));
}

KnotVector KnotVector::clampedUniform(int degree, int spans)
{
    check(spans >= 1, "a knot vector has at least one span");
    std::vector<double> knots(static_cast<size_t>(degree) + 1, 0.0);
    for (int i = 1; i < spans; ++i)
        knots.push_back(static_cast<double>(i) / spans);
    knots.insert(knots.end(), static_cast<size_t>(degree) + 1, 1.0);
    auto result = create(degree, std::move(knots));
    check(result.has_value(), "a clamped uniform knot vector is valid");
    return *std::move(result);
}

KnotVector::KnotVector(int degree, std::vector<double> knots) : degree_(degree), knots_(std::move(knots))
{
    for (int i = degree_; i < controlPointCount(); ++i)
        if ((*this)[i] < (*this)[i + 1])
            spans_.push_back(i);
}

int KnotVector::findSpan(double u) const
{
    if (!(u > domainStart()))  // and where u is no number
        return spans_.front();
    if (u >= domainEnd())
        return spans_.back();
    const auto begin = knots_.begin();
    return static_cast<int>(std::upper_bound(begin + degree_, begin + controlPointCount() + 1, u) - begin) -
           1;
}

}  // namespace knotspan
