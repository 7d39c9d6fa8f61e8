#include "ui/plots/plot_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace knotspan {

PlotAxis::PlotAxis(const std::vector<double>& values, double start, double end) : start_(start), end_(end)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values)
        if (value > 0) {
            low = std::min(low, std::log10(value));
            high = std::max(high, std::log10(value));
        }
    if (low > high)
        low = high = 0;
    // No marker in a corner.
    constexpr double kMargin = 0.1;
    low_ = static_cast<int>(std::floor(low - kMargin));
    high_ = static_cast<int>(std::ceil(high + kMargin));
}

double PlotAxis::pixel(double value) const
{
    if (!(value > 0))
        return start_;
    return start_ + (std::log10(value) - low_) / (high_ - low_) * (end_ - start_);
}

std::vector<PlotAxis::Tick> PlotAxis::ticks() const
{
    const int step = (high_ - low_ + 11) / 12;
    std::vector<Tick> result;
    for (int decade = low_; decade <= high_; ++decade) {
        result.push_back({std::pow(10.0, decade), (decade - low_) % step == 0});
        if (high_ - low_ <= 3 && decade < high_)
            for (const int part : {2, 5})
                result.push_back({part * std::pow(10.0, decade), true});
    }
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
