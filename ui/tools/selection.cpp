#include "ui/tools/selection.h"

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

void Selection::setObjects(std::set<ObjectId> objects)
{
    if (objects == objects_)
        return;
    objects_ = std::move(objects);
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
    for (const auto& [id, chosen] : points_.objects())
        objects_.insert(id);
    Q_EMIT changed();
}

void Selection::setHovered(const Point& point)
{
    if (same(point, hovered_))
        return;
    hovered_ = point;
    Q_EMIT changed();
}

void Selection::clear()
{
    if (objects_.empty() && !hovered_)
        return;
    objects_.clear();
    points_ = {};
    hovered_.reset();
    Q_EMIT changed();
}

void Selection::keepOnly(const Scene& scene)
{
    std::set<ObjectId> kept;
    for (const ObjectId id : objects_)
        if (scene.find(id))
            kept.insert(id);
    if (hovered_ && !isIn(scene, *hovered_))
        setHovered({});
    PointSelection points = points_;
    points.keepOnly(scene);
    setPoints(std::move(points));
    setObjects(std::move(kept));
}

}  // namespace knotspan
