#include "model/scene/edit.h"

#include <utility>

namespace knotspan {

void Edit::set(ObjectId id, SharedObject object)
{
    objects_[id] = std::move(object);
}

void Edit::setMesh(ObjectId id, SharedMesh mesh)
{
    meshes_[id] = std::move(mesh);
}

void Edit::applyTo(Scene& scene)
{
    for (auto& [id, object] : objects_)
        object = scene.exchange(id, std::move(object));
    for (auto& [id, mesh] : meshes_)
        mesh = scene.exchangeMesh(id, std::move(mesh));
    if (units_) {
        std::string before = scene.units();
        scene.setUnits(std::exchange(*units_, std::move(before)));
    }
}

void Edit::absorb(const Edit& later)
{
    // Where both hold an object, this one's is the older: what stood there before either.
    objects_.insert(later.objects_.begin(), later.objects_.end());
    meshes_.insert(later.meshes_.begin(), later.meshes_.end());
    if (!units_)
        units_ = later.units_;
}

namespace {

template <class Objects, class Set>
void setDifferences(const Objects& from, const Objects& to, const Set& set)
{
    for (const auto& [id, object] : from)
        if (to.count(id) == 0)
            set(id, nullptr);
    for (const auto& [id, object] : to)
        if (const auto old = from.find(id);
            old == from.end() || (old->second != object && !(*old->second == *object)))
            set(id, object);
}

}  // namespace

Edit editBetween(const Scene& from, const Scene& to)
{
    Edit edit;
    setDifferences(from.objects(), to.objects(),
                   [&](ObjectId id, SharedObject object) { edit.set(id, std::move(object)); });
    setDifferences(from.meshes(), to.meshes(),
                   [&](ObjectId id, SharedMesh mesh) { edit.setMesh(id, std::move(mesh)); });
    if (from.units() != to.units())
        edit.setUnits(to.units());
    return edit;
}

}  // namespace knotspan
