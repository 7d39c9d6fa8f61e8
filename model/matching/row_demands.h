// What rows 1 and 2 of a net have to do so that the surface has given tangent planes and curvatures along its
// edge: linear conditions on one row at a time, for given weights.
#pragma once

#include "model/matching/row_fit.h"
#include "model/matching/target_frames.h"

namespace knotspan {

// Row 1: x_u . n = 0 at each of the parameters.
[[nodiscard]] std::vector<RowSample> tangentDemands(const NurbsSurface& surface, const TargetFrames& target,
                                                    const std::vector<double>& parameters);

// Row 2, after row 1 is right: x_uu . n is what the second fundamental form says of x_u when it has the
// target's curvature across the edge. The degree across is at least 2.
[[nodiscard]] std::vector<RowSample> curvatureDemands(const NurbsSurface& surface, const TargetFrames& target,
                                                      const std::vector<double>& parameters);

}  // namespace knotspan
