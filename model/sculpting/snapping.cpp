#include "model/sculpting/snapping.h"

#include <cmath>

#include "model/core/check.h"

namespace knotspan {

namespace {

std::vector<ScenePoint> pointsOf(const Scene& scene, const std::set<ObjectId>& objects,
                                 const PointSelection& moving)
{
    std::vector<ScenePoint> points;
    for (const ObjectId id : objects) {
        PointSelection rest = netOf(scene, id);
        rest.remove(moving);
        // What else is moving is no point of this object.
        const auto mine = rest.objects().find(id);
        if (mine != rest.objects().end())
            for (const ControlPointIndex index : mine->second.points)
                points.push_back({id, index});
    }
    return points;
}

std::vector<Vec3> positionsOf(const Scene& scene, const std::vector<ScenePoint>& points)
{
    std::vector<Vec3> positions;
    SharedObject object;
    for (size_t k = 0; k < points.size(); ++k) {
        if (k == 0 || points[k].object != points[k - 1].object)
            object = scene.find(points[k].object);
        positions.push_back(controlPointInModel(*object, points[k].index));
    }
    return positions;
}

}  // namespace

Vec3 snappedToGrid(const Vec3& position, double step)
{
    check(step > 0, "a grid's step is above zero");
    return {std::round(position.x / step) * step, std::round(position.y / step) * step,
            std::round(position.z / step) * step};
}

PointSnap::PointSnap(const Scene& scene, const std::set<ObjectId>& objects, const PointSelection& moving)
    : points_(pointsOf(scene, objects, moving)),
      positions_(positionsOf(scene, points_)),
      tree_(positions_)
{
}

std::optional<PointSnap::Place> PointSnap::nearest(const Vec3& position, double reach) const
{
    const auto found = tree_.nearest(position, reach);
    if (!found)
        return std::nullopt;
    return Place{points_[found->index], positions_[found->index], found->distance};
}

}  // namespace knotspan
