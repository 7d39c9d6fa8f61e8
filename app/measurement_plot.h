// A drawing of measurements: markers over two logarithmic axes, with a legend, as SVG.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

class QIODevice;

namespace knotspan::app {

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
    std::vector<LegendEntry> legend;
};

// The k-th of colours that people who see few colours tell apart, too (Okabe and Ito, 2008); after the last
// one the first comes again.
[[nodiscard]] std::string plotColour(size_t k);

// Each marker is a group of class `marker`. False where the device refused something.
[[nodiscard]] bool writeSvg(const Plot& plot, QIODevice& device);

}  // namespace knotspan::app
