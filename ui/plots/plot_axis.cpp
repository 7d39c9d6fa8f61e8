#include "ui/plots/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace knotspan {

namespace {

constexpr int kMostFineDecades = 3;  // with more, only whole ones are marked

// 1, 2, 5, 10, 20, …: the k-th, also below 0.
double roundNumber(int k)
{
    const int decade = static_cast<int>(std::floor(k / 3.0));
    constexpr double kParts[] = {1, 2, 5};
    return kParts[k - 3 * decade] * std::pow(10.0, decade);
}

}  // namespace

PlotAxis::PlotAxis(const std::vector<double>& values, double start, double end) : start_(start), end_(end)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values)
        if (value > 0) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (low > high)
        low = high = 1;
    constexpr double kMargin = 1.1;  // no marker in a corner
    low /= kMargin;
    high *= kMargin;
    first_ = 3 * static_cast<int>(std::floor(std::log10(low)));
    last_ = 3 * static_cast<int>(std::ceil(std::log10(high)));
    if (last_ - first_ > 3 * kMostFineDecades)
        return;
    while (roundNumber(first_ + 1) <= low)
        ++first_;
    while (roundNumber(last_ - 1) >= high)
        --last_;
}

double PlotAxis::pixel(double value) const
{
    if (!(value > 0))
        return start_;
    const double low = std::log10(roundNumber(first_));
    const double high = std::log10(roundNumber(last_));
    return start_ + (std::log10(value) - low) / (high - low) * (end_ - start_);
}

std::vector<PlotAxis::Tick> PlotAxis::ticks() const
{
    std::vector<Tick> result;
    const bool isFine = last_ - first_ <= 3 * kMostFineDecades;
    const int labelled = isFine ? 1 : 3 * ((last_ - first_ + 33) / 36);
    for (int k = first_; k <= last_; k += isFine ? 1 : 3)
        result.push_back({roundNumber(k), (k - first_) % labelled == 0});
    return result;
}

std::string tickText(double value)
{
    const double decade = std::floor(std::log10(value) + 1e-9);
    char text[32];
    if (decade >= -3 && decade <= 4)
        std::snprintf(text, sizeof text, "%g", value);
    else
        std::snprintf(text, sizeof text, "%.0fe%.0f", value / std::pow(10.0, decade), decade);
    return text;
}

}  // namespace knotspan
