// Where a dragged position goes when it is to snap: to a grid, or to a control point nearby.
#pragma once

#include <optional>

#include "model/sculpting/nearest_points.h"
#include "model/sculpting/point_selection.h"

namespace knotspan {

// The nearest point of the grid with lines every `step` (model units, above 0) through the origin, in each of
// x, y and z.
[[nodiscard]] Vec3 snappedToGrid(const Vec3& position, double step);

// The control points of some objects where they stand as a gesture begins.
class PointSnap {
public:
    // Without those of `moving`: what moves does not snap to itself. Objects that the scene has not are none.
    PointSnap(const Scene& scene, const std::set<ObjectId>& objects, const PointSelection& moving);

    struct Place {
        ScenePoint point;
        Vec3 position{0};
        double distance = 0;  // from where it was asked for
    };
    // The nearest no further than `reach`, all in model space; of those equally near the first by object and
    // index.
    [[nodiscard]] std::optional<Place> nearest(const Vec3& position, double reach) const;

private:
    std::vector<ScenePoint> points_;
    std::vector<Vec3> positions_;
    NearestPoints tree_;
};

}  // namespace knotspan
