// Where everything of a plot is, in pixels: computed once, for a file and for a window.
#pragma once

#include "ui/plots/plot.h"

namespace knotspan {

constexpr double kMarkerRadius = 6;
constexpr double kRingRadius = kMarkerRadius + 5;

struct PlotPoint {
    double x = 0;
    double y = 0;
};

struct PlotLine {
    PlotPoint from, to;
    std::string colour;
};

enum class PlotAnchor : std::uint8_t { start, middle, end };

struct PlotText {
    PlotPoint at;  // on the base line
    std::string text;
    PlotAnchor anchor = PlotAnchor::start;
    int size = 13;
    bool bold = false;
    bool upwards = false;  // turned by a quarter
};

struct PlotSymbol {
    PlotPoint at;
    MarkerLook look;
};

struct PlotLayout {
    std::vector<PlotLine> lines;
    std::vector<PlotText> texts;
    std::vector<std::vector<PlotPoint>> curves;  // as plot.curves
    std::vector<PlotPoint> markers;              // as plot.markers
    std::vector<PlotSymbol> legend;
};

constexpr double kPlotWidth = 960;
constexpr double kPlotHeight = 600;

[[nodiscard]] PlotLayout layoutOf(const Plot& plot, double width = kPlotWidth, double height = kPlotHeight);

}  // namespace knotspan
