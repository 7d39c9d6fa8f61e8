#include "model/scene/edit.h"

namespace knotspan {

void Edit::set(ObjectId id, SharedObject object)
{
    objects_[id] = std::move(object);
}

void Edit::applyTo(Scene& scene)
{
    for (auto& [id, object] : objects_)
        object = scene.exchange(id, std::move(object));
}

void Edit::absorb(const Edit& later)
{
    // Where both hold an object, this one's is the older: what stood there before either.
    objects_.insert(later.objects_.begin(), later.objects_.end());
}

}  // namespace knotspan
