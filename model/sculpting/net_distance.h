// How far a net's control points are from some of them along the net's lines.
#pragma once

#include <limits>
#include <vector>

#include "model/scene/scene_object.h"
#include "model/sculpting/net_size.h"

namespace knotspan {

enum class NetMeasure {
    steps,    // each line between neighbours counts 1
    lengths,  // its length in model space
};

// For each control point, as the surface stores them, the shortest way along the net to the nearest of `from`
// (Dijkstra's algorithm); infinity where that is `reach` or more. Twins at a seam are no way apart.
[[nodiscard]] std::vector<double> distancesAlongNet(const SceneObject& object,
                                                    const std::vector<ControlPointIndex>& from,
                                                    NetMeasure measure,
                                                    double reach = std::numeric_limits<double>::infinity());

}  // namespace knotspan
