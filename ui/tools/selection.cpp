#include "ui/tools/selection.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace knotspan {

namespace {

using Point = std::optional<PickedControlPoint>;

bool same(const Point& a, const Point& b)
{
    if (!a || !b)
        return a.has_value() == b.has_value();
    return a->object == b->object && a->index == b->index;
}

bool isIn(const Scene& scene, const PickedControlPoint& point)
{
    const SharedObject object = scene.find(point.object);
    return object && point.index.i < object->surface.countU() && point.index.j < object->surface.countV();
}

}  // namespace

void Selection::noteLatest(const std::set<ObjectId>& before)
{
    std::vector<ObjectId> added;
    std::set_difference(objects_.begin(), objects_.end(), before.begin(), before.end(),
                        std::back_inserter(added));
    if (objects_.size() == 1)
        latest_ = *objects_.begin();
    else if (added.size() == 1)
        latest_ = added.front();
    else if (!added.empty() || (latest_ && !contains(*latest_)))
        latest_.reset();
}

void Selection::setObjects(std::set<ObjectId> objects, std::set<ObjectId> meshes)
{
    if (objects == objects_ && meshes == meshes_)
        return;
    noteLatest(std::exchange(objects_, std::move(objects)));
    meshes_ = std::move(meshes);
    PointSelection others;
    for (const auto& [id, chosen] : points_.objects())
        if (!contains(id))
            others.add(PointSelection(id, chosen.net, chosen.points));
    points_.remove(others);
    Q_EMIT changed();
}

void Selection::setPoints(PointSelection points)
{
    if (points == points_)
        return;
    points_ = std::move(points);
    const std::set<ObjectId> before = objects_;
    for (const auto& [id, chosen] : points_.objects())
        objects_.insert(id);
    noteLatest(before);
    Q_EMIT changed();
}

void Selection::setHovered(const Point& point)
{
    if (same(point, hovered_) && !hoveredObject_)
        return;
    hovered_ = point;
    hoveredObject_.reset();
    Q_EMIT changed();
}

void Selection::setHoveredObject(std::optional<ObjectId> object)
{
    if (object == hoveredObject_ && !hovered_)
        return;
    hovered_.reset();
    hoveredObject_ = object;
    Q_EMIT changed();
}

void Selection::clear()
{
    if (objects_.empty() && meshes_.empty() && !hovered_ && !hoveredObject_)
        return;
    objects_.clear();
    latest_.reset();
    meshes_.clear();
    points_ = {};
    hovered_.reset();
    hoveredObject_.reset();
    Q_EMIT changed();
}

void Selection::keepOnly(const Scene& scene)
{
    std::set<ObjectId> kept;
    PointSelection points = points_;
    points.keepOnly(scene);
    for (const auto& [id, chosen] : points_.objects())
        if (const SharedObject object = scene.find(id); object && !object->visible)
            points.remove(PointSelection(id, chosen.net, chosen.points));
    for (const ObjectId id : objects_)
        if (const SharedObject object = scene.find(id); object && !object->locked)
            kept.insert(id);
    if (hovered_ && !isIn(scene, *hovered_))
        setHovered({});
    if (hoveredObject_ && !scene.find(*hoveredObject_))
        setHoveredObject({});
    std::set<ObjectId> meshes;
    for (const ObjectId id : meshes_)
        if (scene.meshes().count(id) != 0)
            meshes.insert(id);
    setPoints(std::move(points));
    setObjects(std::move(kept), std::move(meshes));
}

}  // namespace knotspan
