#include "model/scene/object_counts.h"

#include <set>

namespace knotspan {

void ObjectCounts::follow(const Scene& scene)
{
    if (const auto exchanged = scene.changedSince(scene_)) {
        for (const ObjectId id : std::set<ObjectId>(exchanged->begin(), exchanged->end())) {
            count(scene_.find(id), false);
            count(scene.find(id), true);
        }
    } else {
        hidden_ = 0;
        locked_ = 0;
        for (const auto& [id, object] : scene.objects())
            count(object, true);
    }
    scene_ = scene;
}

void ObjectCounts::count(const SharedObject& object, bool comes)
{
    if (object == nullptr)
        return;
    const auto change = [comes](size_t& number) { comes ? ++number : --number; };
    if (!object->visible)
        change(hidden_);
    if (object->locked)
        change(locked_);
}

}  // namespace knotspan
