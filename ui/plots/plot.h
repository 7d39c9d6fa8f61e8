// A drawing of measurements: markers over two logarithmic axes, curves through some of them, a legend.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace knotspan {

enum class MarkerShape : std::uint8_t { circle, square };

struct MarkerLook {
    MarkerShape shape = MarkerShape::circle;
    std::string colour;   // "#rrggbb"
    bool filled = true;   // or only its outline
    bool ringed = false;  // with a thin ring around
};

// x is above 0; y at least 0, and where it is 0 the marker stands on the axis.
struct Marker {
    double x = 0;
    double y = 0;
    MarkerLook look;
    std::string text;  // of its tooltip
};

// A line from marker to marker.
struct Curve {
    std::vector<size_t> markers;  // indices
    std::string colour;
    bool dashed = false;
    bool strong = false;
};

struct LegendEntry {
    MarkerLook look;
    std::string text;
};

struct Plot {
    std::string title;
    std::string subtitle;
    std::string xLabel;
    std::string yLabel;
    std::vector<Marker> markers;
    std::vector<Curve> curves;
    std::vector<LegendEntry> legend;
};

// The k-th of colours that people who see few colours tell apart, too (Okabe and Ito, 2008); after the last
// one the first comes again.
[[nodiscard]] std::string plotColour(size_t k);
[[nodiscard]] size_t plotColourCount();

}  // namespace knotspan
