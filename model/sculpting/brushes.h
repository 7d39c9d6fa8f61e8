// Sculpt brushes: what one dab does to a surface's control points around the place that was hit: to those
// that stand within its radius, and those whose place on the surface (at their Greville parameters) does, so
// that a brush reaches a point that was pulled far off.
//
// All a dab moves is found from the object as it was, then moved together, so neither the order of points nor
// that of the two halves of a symmetric dab counts. Points at a seam or a pole stay together.
#pragma once

#include <optional>

#include "model/scene/edit.h"
#include "model/sculpting/mirroring.h"

namespace knotspan {

enum class BrushKind {
    grab,     // takes the points along with the hand
    smooth,   // towards the mean of their neighbours in the net: border points along the border, corners stay
    inflate,  // along the surface's normal
    flatten,  // towards the plane that fits the points within the radius best
};

struct Dab {
    Vec3 centre{0};     // in model space
    double radius = 1;  // in model units, above 0
    // At the centre; towards the radius it falls off by `shape`. Smooth and flatten: the share of the way, 0
    // to 1. Grab: of `by`, 0 to 1. Inflate: how many radii, -1 to 1; below 0 it deflates.
    double strength = 0.5;
    FalloffShape shape = FalloffShape::smooth;
    Vec3 by{0};                           // of grab: where the hand went, in model space
    std::optional<SymmetryPlane> mirror;  // the same at the mirror image, at once
};

// The same pointer where no point moves. Fails, with a sentence, for a radius or strength outside its range,
// and where a point would not be at a finite place.
[[nodiscard]] Result<SharedObject> dabbed(const SharedObject& object, BrushKind brush, const Dab& dab);

// The same for each of `objects` that it reaches; of others the edit says nothing.
[[nodiscard]] Result<Edit> dabbed(const Scene& scene, const std::set<ObjectId>& objects, BrushKind brush,
                                  const Dab& dab);

}  // namespace knotspan
