// How far two models are from each other, be they surfaces or meshes.
#pragma once

#include <string>

#include "model/core/result.h"
#include "model/mesh/mesh_distance.h"
#include "model/scene/scene.h"

namespace knotspan {

struct SceneDistance {
    // From the points of one to the nearest of the other.
    MeshDistance aToB;
    MeshDistance bToA;
    // What a's and b's surfaces may be off the meshes that stand for them here, and rounding.
    double surfaces = 0;
    std::vector<std::string> notes;  // sentences for the user

    [[nodiscard]] const MeshDistance& larger() const { return aToB.largest >= bToA.largest ? aToB : bToA; }
    [[nodiscard]] double mean() const;  // over both, by area
    // The largest distance is known to within this, either way.
    [[nodiscard]] double uncertainty() const;
};

// Of what is visible, in units of `a`. `scale`: so many of them is one of `b`. Refuses a model with nothing
// in it. Of trimmed faces, what their loops leave.
[[nodiscard]] Result<SceneDistance> distanceBetween(const Scene& a, const Scene& b, double scale = 1);

}  // namespace knotspan
