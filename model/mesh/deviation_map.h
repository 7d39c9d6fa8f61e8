// How far each point of some surfaces is from a reference: for colours, with the largest and the mean.
#pragma once

#include <functional>
#include <string>

#include "model/mesh/mesh_distance.h"
#include "model/scene/scene.h"
#include "model/scene/surface_numbers.h"

namespace knotspan {

struct DeviationMap {
    // Distances of the measured surfaces' points, never negative. The values on the grids are true to
    // within `bound` and float's rounding; between them what interpolation gives is true to about
    // `accuracy`, which was measured where the grids were halved, not proved.
    SharedSurfaceNumbers distances;
    double accuracy = 0;
    double bound = 0;  // how far surfaces may be off the meshes that stand for them

    MeshDistance figures;  // of all measured surfaces together
    // The largest distance is known to within this, either way: proved.
    [[nodiscard]] double uncertainty() const { return figures.uncertainty + bound; }
    std::vector<std::string> notes;  // sentences for the user
};

// Of what is visible in both, in units of `measured`; its meshes do not count, those of the reference do.
// `scale`: so many of those units are one of the reference's. Refuses scenes with nothing to compare.
// Where `isOff` says so, gives up soon with some failure.
[[nodiscard]] Result<DeviationMap> deviationMap(const Scene& measured, const Scene& reference,
                                                double scale = 1, const std::function<bool()>& isOff = {});

}  // namespace knotspan
