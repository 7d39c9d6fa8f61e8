#include "model/mesh/scene_distance.h"

#include <algorithm>

#include "model/mesh/compared_models.h"

namespace knotspan {

double SceneDistance::mean() const
{
    const double area = aToB.area + bToA.area;
    return area > 0 ? (aToB.mean * aToB.area + bToA.mean * bToA.area) / area : 0;
}

double SceneDistance::uncertainty() const
{
    const double found = larger().largest;
    const double possible =
        std::max(aToB.largest + aToB.uncertainty, bToA.largest + bToA.uncertainty) - found;
    return possible + surfaces;
}

Result<SceneDistance> distanceBetween(const Scene& a, const Scene& b, double scale)
{
    const auto models = comparedModels(a, b, scale);
    if (!models)
        return tl::unexpected(models.error());
    SceneDistance result;
    result.surfaces = models->bound();
    const double tolerance = models->tolerance();
    result.aToB = distanceFrom(models->a.mesh, models->b.mesh, tolerance);
    result.bToA = distanceFrom(models->b.mesh, models->a.mesh, tolerance);
    result.notes = models->notes();
    return result;
}

}  // namespace knotspan
