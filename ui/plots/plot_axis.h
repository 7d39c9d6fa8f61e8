// A logarithmic axis: from one of 1, 2, 5, 10, 20, … to another, or over whole decades where there are many.
#pragma once

#include <string>
#include <vector>

namespace knotspan {

class PlotAxis {
public:
    // Holds all `values` above 0, from the pixel `start` to `end`.
    PlotAxis(const std::vector<double>& values, double start, double end);

    // A value of 0 is at the start.
    [[nodiscard]] double pixel(double value) const;

    struct Tick {
        double value;
        bool labelled;
    };
    [[nodiscard]] std::vector<Tick> ticks() const;

private:
    double start_;
    double end_;
    int first_;  // of those numbers; 0 is 1, 3 is 10
    int last_;
};

// 0.01, 20, 1e-7, 1e6
[[nodiscard]] std::string tickText(double value);

}  // namespace knotspan
