// Where a control point's own u, v and normal point to: the directions that a drag can keep to.
#pragma once

#include <vector>

#include "model/scene/scene_object.h"
#include "model/sculpting/net_neighbours.h"

namespace knotspan {

// The parameter at which control point k weighs most: the mean of the degree knots after it, in the domain.
[[nodiscard]] double grevilleParameter(const KnotVector& knots, int k);

// In model space, unit: along the net from the neighbour before to the one after (over a seam too). Zero
// where they coincide, as round a pole. Twins and a pole's points have one direction.
[[nodiscard]] Vec3 directionAlongNet(const SceneObject& object, const NetNeighbours& neighbours,
                                     ControlPointIndex index, Direction direction);

// In model space, unit: the surface's normal at the Greville parameters of each point, on its front also
// where the object's transform mirrors. Twins and a pole's points have one normal; at a crease it is that of
// the part behind. Many at once are fastest.
[[nodiscard]] std::vector<Vec3> normalsAt(const SceneObject& object, const NetNeighbours& neighbours,
                                          const std::vector<ControlPointIndex>& points);

}  // namespace knotspan
