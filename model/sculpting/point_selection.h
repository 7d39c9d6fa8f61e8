// Which control points are chosen, of how many objects there may be: a value.
//
// Each object's net size is kept beside its points: an index says something only as long as the net keeps its
// shape. Where a selection and a newer one disagree about it, the newer one is right.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "model/scene/scene.h"
#include "model/sculpting/net_size.h"

namespace knotspan {

// Names one control point of a scene.
struct ScenePoint {
    ObjectId object{};
    ControlPointIndex index;

    [[nodiscard]] bool operator==(const ScenePoint&) const = default;
};

struct SelectedPoints {
    NetSize net;
    std::vector<ControlPointIndex> points;  // in the order of comesBefore(), none twice, at least one

    [[nodiscard]] bool operator==(const SelectedPoints&) const = default;
};

class PointSelection {
public:
    PointSelection() = default;
    // Of one object: `points` of its net, in any order, some perhaps twice.
    PointSelection(ObjectId object, NetSize net, std::vector<ControlPointIndex> points);

    [[nodiscard]] const std::map<ObjectId, SelectedPoints>& objects() const { return objects_; }
    [[nodiscard]] bool isEmpty() const { return objects_.empty(); }
    [[nodiscard]] size_t size() const;  // points
    [[nodiscard]] bool contains(const ScenePoint& point) const;

    void add(const PointSelection& others);
    void remove(const PointSelection& others);
    // What is in one of both, not in both.
    void toggle(const PointSelection& others);

    // Lets go of objects that the scene no longer has or whose net has another size.
    void keepOnly(const Scene& scene);

    [[nodiscard]] bool operator==(const PointSelection&) const = default;

private:
    template <class Combine>
    void combine(const PointSelection& others, const Combine& combine);

    std::map<ObjectId, SelectedPoints> objects_;
};

// Nothing where the scene has no such object, or its net no such point.
[[nodiscard]] PointSelection pointOf(const Scene& scene, const ScenePoint& point);
[[nodiscard]] PointSelection rowOf(const Scene& scene, ObjectId object, int i);     // all (i, j) of one i
[[nodiscard]] PointSelection columnOf(const Scene& scene, ObjectId object, int j);  // all (i, j) of one j
[[nodiscard]] PointSelection netOf(const Scene& scene, ObjectId object);

// With the neighbours along u and v of each point.
[[nodiscard]] PointSelection grown(const PointSelection& selection);
// Without the points that have a neighbour which is not selected; beyond the net's border nothing is missed.
[[nodiscard]] PointSelection shrunk(const PointSelection& selection);
// The other points of the objects that it has points of.
[[nodiscard]] PointSelection inverted(const PointSelection& selection);
// Those of `objects` that are not selected.
[[nodiscard]] PointSelection inverted(const PointSelection& selection, const Scene& scene,
                                      const std::set<ObjectId>& objects);

}  // namespace knotspan
