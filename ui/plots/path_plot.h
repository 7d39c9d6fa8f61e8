// The measurement of paths as a drawing: error against time, a curve a path.
#pragma once

#include "renderer/measurement/path_measurement.h"
#include "ui/plots/plot.h"

namespace knotspan {

struct PathPlot {
    Plot plot;
    std::vector<size_t> rows;  // of each marker: which of the rows
};

// What to draw, and what a window has chosen.
struct PathPlotRequest {
    Deformation motion = Deformation::none;
    std::optional<PathId> strongPath;
    std::optional<double> ringedTolerance;  // each path's point next to it gets a ring
};

// Of the rows of one motion that have a measured error. Title and subtitle are the caller's.
[[nodiscard]] PathPlot pathPlot(const std::vector<PathRow>& rows, const PathPlotRequest& request);

// "mesh at 0.5 px: 12.3 ms a frame, ..."
[[nodiscard]] std::string describe(const PathRow& row);

}  // namespace knotspan
