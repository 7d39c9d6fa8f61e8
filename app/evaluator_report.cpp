#include "app/evaluator_report.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include <nlohmann/json.hpp>

namespace knotspan::app {
namespace {

using Json = nlohmann::ordered_json;

std::string precisionName(Precision precision)
{
    return precision == Precision::float32 ? "float" : "double";
}

std::string processorName(Processor processor)
{
    return processor == Processor::cpu ? "cpu" : "gpu";
}

std::string numberText(const char* format, double number)
{
    char text[64];
    std::snprintf(text, sizeof text, format, number);
    return text;
}

std::string counted(size_t count, const std::string& what)
{
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

bool runsOnTheProcessor(const std::string& device)
{
    return device.find("llvmpipe") != std::string::npos || device.find("SwiftShader") != std::string::npos;
}

std::string degreesText(const EvaluatorReport& report)
{
    const std::string low = std::to_string(report.lowestDegree);
    return report.lowestDegree == report.highestDegree
               ? "degree " + low
               : "degrees " + low + " to " + std::to_string(report.highestDegree);
}

std::string headText(const EvaluatorReport& report)
{
    std::string text = report.file + ": " + counted(report.surfaces, "surface") + " of " +
                       degreesText(report) + ", " + counted(report.ksquads, "KSQuad") + "\n";
    text += counted(report.points, "random point") + ", the same for every row but the grid's; errors at " +
            std::to_string(report.exactPoints) + " of them\n";
    text += "cpu: one thread, instructions " + report.simd + "\n";
    text += "gpu: " + (report.device.empty() ? "none" : report.device) +
            (runsOnTheProcessor(report.device) ? ", a software driver on all threads of the processor" : "") +
            "; by the device's clock, without transfers\n";
    return text;
}

std::string tailText()
{
    std::string text =
        "* what `auto` takes for this model.\n"
        "A point is a position, both first derivatives and a unit normal. An error is the distance of "
        "a position from the exact one,\n"
        "relative to the largest coordinate of the KSQuad's control points, from the surface's own "
        "origin; a unit is 2^-24 of that in\n"
        "float, 2^-53 in double.\n";
    if (std::numeric_limits<Exact>::digits <= std::numeric_limits<double>::digits)
        text += "This machine has no number type wider than double: errors in double are those of the exact "
                "positions, "
                "too.\n";
    return text;
}

std::string rowText(const EvaluatorRow& row)
{
    char text[160];
    std::snprintf(text, sizeof text, "%-11s %-9s %-9s ", (row.evaluator + (row.automatic ? "*" : "")).c_str(),
                  precisionName(row.precision).c_str(), processorName(row.processor).c_str());
    std::string line = text;
    if (!row.unavailable.empty())
        return line + "not measured: " + row.unavailable + "\n";
    std::snprintf(text, sizeof text, "%12.2f %10.2f %12.2e %12.2e %10.2f\n", row.millionPointsPerSecond,
                  nanosecondsPerPoint(row), row.errorMax, row.errorMean, inUnits(row, row.errorMax));
    return line + text;
}

// Of the plot: evaluators by colour in the order of the rows.
class Looks {
public:
    explicit Looks(const std::vector<EvaluatorRow>& rows)
    {
        for (const EvaluatorRow& row : rows)
            if (std::find(names_.begin(), names_.end(), row.evaluator) == names_.end())
                names_.push_back(row.evaluator);
    }

    [[nodiscard]] MarkerLook of(const EvaluatorRow& row) const
    {
        const auto found = std::find(names_.begin(), names_.end(), row.evaluator);
        return {row.precision == Precision::float32 ? MarkerShape::circle : MarkerShape::square,
                plotColour(static_cast<size_t>(found - names_.begin())), row.processor == Processor::cpu,
                row.automatic};
    }

    [[nodiscard]] std::vector<LegendEntry> legend() const
    {
        std::vector<LegendEntry> entries;
        const auto add = [&](const std::string& text, MarkerShape shape, const std::string& colour,
                             bool filled, bool ringed) {
            const MarkerLook look{shape, colour, filled, ringed};
            entries.push_back({look, text});
        };
        for (size_t k = 0; k < names_.size(); ++k)
            add(names_[k], MarkerShape::circle, plotColour(k), true, false);
        const std::string grey = "#666666";
        add("circle: float", MarkerShape::circle, grey, true, false);
        add("square: double", MarkerShape::square, grey, true, false);
        add("filled: CPU, one thread", MarkerShape::circle, grey, true, false);
        add("hollow: GPU", MarkerShape::circle, grey, false, false);
        add("ringed: what auto takes", MarkerShape::circle, grey, true, true);
        return entries;
    }

private:
    std::vector<std::string> names_;
};

std::string tooltip(const EvaluatorRow& row)
{
    return row.evaluator + ", " + precisionName(row.precision) + ", " + processorName(row.processor) + ": " +
           numberText("%.3g", nanosecondsPerPoint(row)) + " ns a point, largest error " +
           numberText("%.3g", row.errorMax) + ", " + numberText("%.3g", inUnits(row, row.errorMax)) +
           " units";
}

}  // namespace

std::string tableOf(const EvaluatorReport& report)
{
    std::string text = headText(report) + "\n";
    text += "evaluator   number    processor      million         ns      largest         mean   largest\n"
            "                                    points/s    a point        error        error  in units\n";
    const EvaluatorRow* before = nullptr;
    for (const EvaluatorRow& row : report.rows) {
        if (before != nullptr && (before->precision != row.precision || before->processor != row.processor))
            text += '\n';
        text += rowText(row);
        before = &row;
    }
    return text + "\n" + tailText();
}

nlohmann::ordered_json jsonOf(const EvaluatorReport& report)
{
    Json rows = Json::array();
    for (const EvaluatorRow& row : report.rows) {
        Json json{{"evaluator", row.evaluator},
                  {"precision", precisionName(row.precision)},
                  {"processor", processorName(row.processor)},
                  {"automatic", row.automatic}};
        if (row.unavailable.empty())
            json.update({{"million_points_per_second", row.millionPointsPerSecond},
                         {"error_max", row.errorMax},
                         {"error_mean", row.errorMean},
                         {"error_max_units", inUnits(row, row.errorMax)}});
        else
            json["unavailable"] = row.unavailable;
        rows.push_back(std::move(json));
    }
    return {{"device", report.device.empty() ? Json(nullptr) : Json(report.device)},
            {"simd", report.simd},
            {"points", report.points},
            {"evaluators", std::move(rows)}};
}

Plot plotOf(const EvaluatorReport& report)
{
    const Looks looks(report.rows);
    Plot plot;
    plot.title = report.file + ": what evaluation costs and how far it is off";
    plot.subtitle =
        "CPU: one thread, " + report.simd + ". GPU: " + (report.device.empty() ? "none" : report.device);
    plot.xLabel = "time per point, nanoseconds";
    plot.yLabel = "largest error of a position, as a part of the local size";
    for (const EvaluatorRow& row : report.rows)
        if (row.unavailable.empty())
            plot.markers.push_back({nanosecondsPerPoint(row), row.errorMax, looks.of(row), tooltip(row)});
    plot.legend = looks.legend();
    return plot;
}

}  // namespace knotspan::app
