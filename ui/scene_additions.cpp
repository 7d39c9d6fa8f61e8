#include "ui/scene_additions.h"

#include "model/making/object_making.h"

namespace knotspan {

void SceneAdditions::add(SceneObject object)
{
    const ObjectId id = numbered_.add(std::move(object));
    edit_.set(id, numbered_.find(id));
    ids_.insert(id);
}

std::string SceneAdditions::addNamed(const QString& kind, NurbsSurface surface)
{
    std::set<std::string> taken;
    for (const auto& [id, object] : numbered_.objects())
        taken.insert(object->name);
    std::string name;
    int number = 0;
    do
        name = QString("%1 %2").arg(kind).arg(++number).toStdString();
    while (taken.count(name) != 0);
    add(SceneObject{.name = name, .surface = std::move(surface), .trimLoops = {}});
    return name;
}

void SceneAdditions::addCopy(const SceneObject& object)
{
    add(duplicated(object, numbered_));
}

int SceneAdditions::controlPointCount() const
{
    size_t count = 0;
    for (const ObjectId id : ids_)
        count += numbered_.find(id)->surface.controlPoints().size();
    return static_cast<int>(count);
}

}  // namespace knotspan
