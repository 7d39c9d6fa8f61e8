#include "ui/plots/plot_layout.h"

#include <array>

#include "ui/plots/plot_axis.h"

namespace knotspan {

namespace {

constexpr std::array kColours{"#0072b2", "#e69f00", "#cc79a7", "#009e73", "#56b4e9", "#d55e00", "#000000"};
constexpr const char* kGrid = "#dddddd";
constexpr const char* kInk = "#222222";

// The rectangle of the axes.
struct Area {
    double left, right, top, bottom;
};

void addAxes(PlotLayout& layout, const Plot& plot, const Area& area, const PlotAxis& x, const PlotAxis& y)
{
    for (const PlotAxis::Tick& tick : x.ticks()) {
        const double at = x.pixel(tick.value);
        layout.lines.push_back({{at, area.top}, {at, area.bottom}, kGrid});
        if (tick.labelled)
            layout.texts.push_back({{at, area.bottom + 20}, tickText(tick.value), PlotAnchor::middle});
    }
    for (const PlotAxis::Tick& tick : y.ticks()) {
        const double at = y.pixel(tick.value);
        layout.lines.push_back({{area.left, at}, {area.right, at}, kGrid});
        if (tick.labelled)
            layout.texts.push_back({{area.left - 8, at + 4}, tickText(tick.value), PlotAnchor::end});
    }
    layout.lines.push_back({{area.left, area.bottom}, {area.right, area.bottom}, kInk});
    layout.lines.push_back({{area.left, area.top}, {area.left, area.bottom}, kInk});
    layout.texts.push_back(
        {{(area.left + area.right) / 2, area.bottom + 50}, plot.xLabel, PlotAnchor::middle});
    layout.texts.push_back({.at = {30, (area.top + area.bottom) / 2},
                            .text = plot.yLabel,
                            .anchor = PlotAnchor::middle,
                            .upwards = true});
}

}  // namespace

std::string plotColour(size_t k)
{
    return kColours[k % kColours.size()];
}

size_t plotColourCount()
{
    return kColours.size();
}

PlotLayout layoutOf(const Plot& plot, double width, double height)
{
    const Area area{100, width - 240, 80, height - 80};
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Marker& marker : plot.markers) {
        xs.push_back(marker.x);
        ys.push_back(marker.y);
    }
    const PlotAxis x(xs, area.left, area.right);
    const PlotAxis y(ys, area.bottom, area.top);
    PlotLayout layout;
    layout.texts.push_back({.at = {area.left, 34}, .text = plot.title, .size = 18, .bold = true});
    layout.texts.push_back({.at = {area.left, 58}, .text = plot.subtitle});
    addAxes(layout, plot, area, x, y);
    for (const Marker& marker : plot.markers)
        layout.markers.push_back({x.pixel(marker.x), y.pixel(marker.y)});
    for (const Curve& curve : plot.curves) {
        layout.curves.emplace_back();
        for (const size_t marker : curve.markers)
            layout.curves.back().push_back(layout.markers[marker]);
    }
    double at = area.top + 12;
    for (const LegendEntry& entry : plot.legend) {
        layout.legend.push_back({{area.right + 35, at}, entry.look});
        layout.texts.push_back({{area.right + 55, at + 4}, entry.text});
        at += 28;
    }
    return layout;
}

}  // namespace knotspan
