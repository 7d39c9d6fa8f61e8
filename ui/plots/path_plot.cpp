#include "ui/plots/path_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace knotspan {

namespace {

template <class... Values>
std::string printed(const char* format, Values... values)
{
    char text[96];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

// Of one curve: a path with an evaluator.
struct Series {
    PathId path;
    Evaluator evaluator;
    std::vector<size_t> markers;
    friend bool operator==(const Series& a, const Series& b)
    {
        return a.path == b.path && a.evaluator == b.evaluator;
    }
};

std::string nameOf(PathId path, Evaluator evaluator)
{
    std::string name = pathInfo(path).name;
    if (evaluator != Evaluator::automatic)
        name += ", " + evaluatorInfo(evaluator).name;
    return name;
}

// Colours come again after a while; then outlines and dashes tell the curves apart.
MarkerLook lookOf(size_t series)
{
    return {MarkerShape::circle, plotColour(series), series < plotColourCount(), false};
}

bool isDrawn(const PathRow& row, Deformation motion)
{
    return row.measured && row.motion == motion && row.stats.errorPxMax && row.frameMs.median > 0;
}

double distance(const PathRow& row, double tolerance)
{
    return row.tolerancePx ? std::abs(std::log(*row.tolerancePx / tolerance)) : 0;
}

class Maker {
public:
    Maker(const std::vector<PathRow>& rows, const PathPlotRequest& request) : rows_(rows), request_(request)
    {
        for (size_t k = 0; k < rows.size(); ++k)
            add(k);
        for (size_t k = 0; k < series_.size(); ++k)
            finish(k);
        if (leaks_)
            explain("square: pixels leak", MarkerShape::square, false);
        if (request.ringedTolerance)
            explain("ringed: tolerance now", MarkerShape::circle, true);
    }

    PathPlot made() && { return std::move(made_); }

private:
    void explain(const std::string& text, MarkerShape shape, bool ringed)
    {
        const MarkerLook look{shape, "#666666", true, ringed};
        made_.plot.legend.push_back({look, text});
    }

    void add(size_t k)
    {
        // All rows count, so that a path keeps its colour from chart to chart.
        const PathRow& row = rows_[k];
        const Series wanted{row.path, row.evaluator, {}};
        auto series = std::find(series_.begin(), series_.end(), wanted);
        if (series == series_.end())
            series = series_.insert(series, wanted);
        if (!isDrawn(row, request_.motion))
            return;
        MarkerLook look = lookOf(static_cast<size_t>(series - series_.begin()));
        if (row.stats.leakPixels.value_or(0) > 0) {
            look.shape = MarkerShape::square;
            leaks_ = true;
        }
        series->markers.push_back(made_.plot.markers.size());
        made_.plot.markers.push_back({row.frameMs.median, *row.stats.errorPxMax, look, describe(row)});
        made_.rows.push_back(k);
    }

    void finish(size_t k)
    {
        const Series& series = series_[k];
        if (series.markers.empty())
            return;
        Plot& plot = made_.plot;
        const MarkerLook look = lookOf(k);
        if (series.markers.size() > 1)
            plot.curves.push_back({series.markers, look.colour, !look.filled,
                                   request_.strongPath && *request_.strongPath == series.path});
        plot.legend.push_back({look, nameOf(series.path, series.evaluator)});
        if (!request_.ringedTolerance)
            return;
        const auto nearer = [&](size_t a, size_t b) {
            return distance(rows_[made_.rows[a]], *request_.ringedTolerance) <
                   distance(rows_[made_.rows[b]], *request_.ringedTolerance);
        };
        const size_t nearest = *std::min_element(series.markers.begin(), series.markers.end(), nearer);
        plot.markers[nearest].look.ringed = true;
    }

    const std::vector<PathRow>& rows_;
    const PathPlotRequest& request_;
    PathPlot made_;
    std::vector<Series> series_;
    bool leaks_ = false;
};

}  // namespace

std::string describe(const PathRow& row)
{
    std::string text = nameOf(row.path, row.evaluator);
    if (row.tolerancePx)
        text += printed(" at %g px", *row.tolerancePx);
    if (!row.unavailable.empty())
        return text + " was not measured: " + row.unavailable;
    text += printed(": %.3g ms a frame (%.3g preparing, %.3g drawing), ", row.frameMs.median,
                    row.stats.cpuMs.median, row.stats.gpuMs.median);
    text += printed("%llu triangles", static_cast<unsigned long long>(row.stats.triangles));
    if (row.stats.errorPxMax)
        text += printed(", largest error %.3g px", *row.stats.errorPxMax);
    if (row.stats.errorPxMean)
        text += printed(", mean %.3g px", *row.stats.errorPxMean);
    if (row.stats.leakPixels)
        text += printed(", %llu leaking pixels", static_cast<unsigned long long>(*row.stats.leakPixels));
    return text;
}

PathPlot pathPlot(const std::vector<PathRow>& rows, const PathPlotRequest& request)
{
    PathPlot made = Maker(rows, request).made();
    made.plot.xLabel = request.motion == Deformation::none
                           ? "a frame, milliseconds"
                           : "a frame with every control point moved, milliseconds";
    made.plot.yLabel = "largest error of the picture, pixels";
    return made;
}

}  // namespace knotspan
