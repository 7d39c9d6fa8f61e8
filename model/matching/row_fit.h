// Moves a row of control points as little as it can so that its curve moves by what is asked for along given
// normals.
#pragma once

#include <optional>

#include "model/geometry/nurbs_surface.h"

namespace knotspan {

// At v the row's curve is to move by `needed` along `normal`; being off by `scale` counts as much
// everywhere.
struct RowSample {
    double v = 0;
    Vec3 normal{};
    double needed = 0;
    double scale = 1;
};

// The parameters to sample at: inside each span, and close to its ends on its own side of them.
[[nodiscard]] std::vector<double> sampleParameters(const KnotVector& along, int perSpan);

// The row's curve at v, with the row's own weights: the rational curve of that row alone.
[[nodiscard]] ControlPoint rowPoint(const KnotVector& along, const std::vector<ControlPoint>& row, double v);

// By least squares: what is needed counts a thousand times as much as how far the curve moves. Weights stay.
// Nothing where the samples' scales leave no solution: they are all 0, or too large for double.
[[nodiscard]] std::optional<std::vector<ControlPoint>> fittedRow(const KnotVector& along,
                                                                 const std::vector<ControlPoint>& row,
                                                                 const std::vector<RowSample>& samples);

}  // namespace knotspan
