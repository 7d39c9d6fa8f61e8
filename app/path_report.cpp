#include "app/path_report.h"

#include <cstdio>

#include "ui/plots/path_plot.h"

namespace knotspan::app {
namespace {

template <class... Values>
std::string printed(const char* format, Values... values)
{
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string titleOf(Deformation motion)
{
    switch (motion) {
    case Deformation::none:
        return "the model is at rest";
    case Deformation::point:
        return "one control point moves in every frame";
    default:
        return "every control point moves in every frame";
    }
}

std::string headText()
{
    constexpr const char* kColumns = "%-21s %-10s %6s %9s %8s %8s %10s %11s %9s %9s %7s\n";
    return printed(kColumns, "path", "evaluator", "asked", "frame", "prepare", "draw", "triangles",
                   "evaluations", "largest", "mean", "leaking") +
           printed(kColumns, "", "", "px", "ms", "ms", "ms", "", "", "error px", "error px", "pixels");
}

std::string errorText(const std::optional<double>& pixels)
{
    return pixels ? printed(" %9.3g", *pixels) : printed(" %9s", "-");
}

std::string rowText(const PathRow& row)
{
    const std::string tolerance = row.tolerancePx ? printed("%g", *row.tolerancePx) : "-";
    const std::string& evaluator = row.measured ? row.stats.evaluator : evaluatorInfo(row.evaluator).name;
    std::string text =
        printed("%-21s %-10s %6s ", pathInfo(row.path).name.c_str(), evaluator.c_str(), tolerance.c_str());
    if (!row.unavailable.empty())
        return text + "not measured: " + row.unavailable + "\n";
    text += printed("%9.2f %8.2f %8.2f %10llu %11llu", row.frameMs.median, row.stats.cpuMs.median,
                    row.stats.gpuMs.median, static_cast<unsigned long long>(row.stats.triangles),
                    static_cast<unsigned long long>(row.stats.evaluations));
    text += errorText(row.stats.errorPxMax) + errorText(row.stats.errorPxMean);
    const auto& leaks = row.stats.leakPixels;
    return text + printed(" %7s\n", leaks ? std::to_string(*leaks).c_str() : "-");
}

std::string pictureText(const PathReport& report)
{
    const Frame& frame = report.request.frame;
    return printed("%d by %d pixels, ", frame.width, frame.height) +
           (report.request.flight.empty() ? "" : printed("%zu views, ", report.request.flight.size())) +
           (report.device ? report.device->name : "no device");
}

}  // namespace

std::string tableOf(const PathReport& report)
{
    std::string text = report.file + ": paths, " + pictureText(report) + "\n";
    for (const Deformation motion : report.request.motions) {
        text += "\n" + titleOf(motion) + "\n";
        text += headText();
        for (const PathRow& row : report.rows)
            if (row.motion == motion)
                text += rowText(row);
    }
    constexpr const char* kNotes =
        "preparing, on the CPU, with the model's changes taken over; then drawing, by the device's clock. "
        "An\n"
        "error is the distance in the picture between a drawn point and the exact surface. A path that was "
        "asked for no tolerance\ndraws the same at every one. Leaks are counted in closed models. The camera "
        "turns by a hair in every frame.\n";
    return text + "\nTimes are medians of up to " + std::to_string(report.request.frames) +
           (report.request.flight.empty() ? " frames: " : " frames a view: ") + kNotes;
}

std::vector<Plot> plotsOf(const PathReport& report)
{
    std::vector<Plot> plots;
    for (const Deformation motion : report.request.motions) {
        Plot plot = pathPlot(report.rows, {motion, {}, {}}).plot;
        plot.title = report.file + ": what a frame costs and how far it is off";
        plot.subtitle = titleOf(motion) + "; " + pictureText(report);
        plots.push_back(std::move(plot));
    }
    return plots;
}

}  // namespace knotspan::app
