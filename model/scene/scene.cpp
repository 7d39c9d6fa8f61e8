#include "model/scene/scene.h"

#include <algorithm>

#include "model/geometry/ksquad.h"

namespace knotspan {

SharedObject Scene::find(ObjectId id) const
{
    const auto found = objects_.find(id);
    return found == objects_.end() ? nullptr : found->second;
}

ObjectId Scene::add(SceneObject object)
{
    const ObjectId id{nextId_};
    exchange(id, std::make_shared<const SceneObject>(std::move(object)));
    return id;
}

SharedObject Scene::exchange(ObjectId id, SharedObject object)
{
    SharedObject before = find(id);
    if (object)
        objects_[id] = std::move(object);
    else
        objects_.erase(id);
    nextId_ = std::max(nextId_, static_cast<std::uint32_t>(id) + 1);
    return before;
}

Box Scene::bounds() const
{
    Box box;
    for (const auto& [id, object] : objects_)
        if (object->visible)
            box.add(object->bounds());
    return box;
}

std::vector<Vec3> Scene::controlPoints() const
{
    std::vector<Vec3> points;
    for (const auto& [id, object] : objects_)
        if (object->visible)
            for (const ControlPoint& point : object->surface.controlPoints())
                points.push_back(transformed(point.position, object->transform));
    return points;
}

size_t Scene::ksQuadCount() const
{
    size_t count = 0;
    for (const auto& [id, object] : objects_)
        count += knotspan::ksQuadCount(object->surface);
    return count;
}

size_t Scene::controlPointCount() const
{
    size_t count = 0;
    for (const auto& [id, object] : objects_)
        count += object->surface.controlPoints().size();
    return count;
}

bool Scene::operator==(const Scene& other) const
{
    return units_ == other.units_ && std::equal(objects_.begin(), objects_.end(), other.objects_.begin(),
                                                other.objects_.end(), [](const auto& a, const auto& b) {
                                                    return a.first == b.first &&
                                                           (a.second == b.second || *a.second == *b.second);
                                                });
}

}  // namespace knotspan
