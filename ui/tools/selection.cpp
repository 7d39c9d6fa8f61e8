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

bool hasOtherNet(const Scene& scene, const PickedControlPoint& point,
                 const std::optional<std::pair<int, int>>& net)
{
    const NurbsSurface& surface = scene.find(point.object)->surface;
    return net && *net != std::pair(surface.countU(), surface.countV());
}

}  // namespace

void Selection::setObjects(std::set<ObjectId> objects)
{
    if (objects == objects_)
        return;
    objects_ = std::move(objects);
    if (controlPoint_ && !contains(controlPoint_->object))
        controlPoint_.reset();
    Q_EMIT changed();
}

void Selection::setControlPoint(const Point& point, const SceneObject* of)
{
    net_.reset();
    if (of != nullptr)
        net_ = {of->surface.countU(), of->surface.countV()};
    if (same(point, controlPoint_))
        return;
    controlPoint_ = point;
    if (point && !contains(point->object))
        objects_ = {point->object};
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
    if (objects_.empty() && !controlPoint_ && !hovered_)
        return;
    objects_.clear();
    controlPoint_.reset();
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
    if (controlPoint_ && (!isIn(scene, *controlPoint_) || hasOtherNet(scene, *controlPoint_, net_)))
        setControlPoint({});
    setObjects(std::move(kept));
}

}  // namespace knotspan
