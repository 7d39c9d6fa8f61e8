// The truth that bounds are tested against: the largest distance on the screen between the triangles of a
// grid and the surface, measured at many points in double.
#pragma once

#include <optional>

#include "model/analysis/grid_choice.h"
#include "model/core/space.h"

namespace knotspan::testing {

// The largest distance in pixels between what is drawn at (u, v) and the surface there, over the points of
// the triangles that the picture shows, at `samples` steps a cell in each direction. Each vertex is on the
// surface; between them homogeneous coordinates are interpolated linearly, as perspective-correct
// interpolation does. Cells are cut from (0, 0) to (1, 1) (rising) or from (1, 0) to (0, 1). Infinite where a
// shown point's surface point is not in front of the eye. Stops at the first point above `enough`.
[[nodiscard]] double measuredError(const BezierNet& pixels, const ScreenView& view, const Grid& grid,
                                   bool rising, int samples, double enough = 1e300);

// The same over one triangle between three parameters, at `samples` steps along each side.
[[nodiscard]] double measuredError(const BezierNet& pixels, const ScreenView& view, const Vec2 (&corners)[3],
                                   int samples);

// The grid of fewest cells that measures within the tolerance, found by trying all up to `cells` cells.
// Nothing where none does.
[[nodiscard]] std::optional<Grid> smallestMeasuredGrid(const BezierNet& pixels, const ScreenView& view,
                                                       double tolerance, bool rising, long cells);

}  // namespace knotspan::testing
