#include "model/scene/scene.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "model/geometry/ksquad.h"

namespace knotspan {

namespace {

std::uint64_t newVersion()
{
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

}  // namespace

Scene& Scene::operator=(const Scene& other)
{
    if (this == &other)
        return *this;
    if (const auto changed = other.changedSince(*this)) {
        for (const ObjectId id : *changed) {
            if (SharedObject object = other.find(id))
                objects_.insert_or_assign(id, std::move(object));
            else
                objects_.erase(id);
        }
    } else {
        objects_ = other.objects_;
    }
    meshes_ = other.meshes_;
    version_ = other.version_;
    latest_ = other.latest_;
    nextExchange_ = other.nextExchange_;
    units_ = other.units_;
    nextId_ = other.nextId_;
    return *this;
}

Scene::Scene(Scene&& other) noexcept
{
    *this = std::move(other);
}

Scene& Scene::operator=(Scene&& other) noexcept
{
    if (this == &other)
        return *this;
    objects_ = std::exchange(other.objects_, {});
    meshes_ = std::exchange(other.meshes_, {});
    version_ = std::exchange(other.version_, 0);
    latest_ = std::exchange(other.latest_, {});
    nextExchange_ = other.nextExchange_;
    units_ = std::move(other.units_);
    nextId_ = std::exchange(other.nextId_, 0);
    return *this;
}

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
    latest_[nextExchange_] = {std::exchange(version_, newVersion()), id};
    nextExchange_ = (nextExchange_ + 1) % latest_.size();
    if (object)
        objects_[id] = std::move(object);
    else
        objects_.erase(id);
    nextId_ = std::max(nextId_, static_cast<std::uint32_t>(id) + 1);
    return before;
}

ObjectId Scene::addMesh(MeshObject mesh)
{
    const ObjectId id{nextId_};
    exchangeMesh(id, std::make_shared<const MeshObject>(std::move(mesh)));
    return id;
}

SharedMesh Scene::exchangeMesh(ObjectId id, SharedMesh mesh)
{
    const auto found = meshes_.find(id);
    SharedMesh before = found == meshes_.end() ? nullptr : found->second;
    if (mesh)
        meshes_[id] = std::move(mesh);
    else
        meshes_.erase(id);
    nextId_ = std::max(nextId_, static_cast<std::uint32_t>(id) + 1);
    return before;
}

std::optional<std::vector<ObjectId>> Scene::changedSince(const Scene& earlier) const
{
    std::vector<ObjectId> changed;
    if (version_ == earlier.version_)
        return changed;
    const auto count = static_cast<std::uint32_t>(latest_.size());
    for (std::uint32_t back = 1; back <= count; ++back) {
        const Exchange& exchange = latest_[(nextExchange_ + count - back) % count];
        changed.push_back(exchange.id);
        // A version of 0 also stands where no exchange was.
        if (exchange.before == earlier.version_)
            return exchange.before != 0 || earlier.objects_.empty() ? std::optional(changed) : std::nullopt;
    }
    return std::nullopt;
}

Box Scene::bounds() const
{
    Box box;
    for (const auto& [id, object] : objects_)
        if (object->visible)
            box.add(object->bounds());
    for (const auto& [id, mesh] : meshes_)
        if (mesh->visible)
            box.add(mesh->bounds());
    return box;
}

std::vector<Vec3> Scene::hullPoints() const
{
    std::vector<Vec3> points;
    for (const auto& [id, object] : objects_)
        if (object->visible)
            for (const ControlPoint& point : object->surface.controlPoints())
                points.push_back(transformed(point.position, object->transform));
    for (const auto& [id, mesh] : meshes_)
        if (mesh->visible)
            for (int corner = 0; corner < 8; ++corner)
                points.push_back(transformed({(corner & 1 ? mesh->box.high : mesh->box.low).x,
                                              (corner & 2 ? mesh->box.high : mesh->box.low).y,
                                              (corner & 4 ? mesh->box.high : mesh->box.low).z},
                                             mesh->transform));
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
    const auto same = [](const auto& a, const auto& b) {
        return a.first == b.first && (a.second == b.second || *a.second == *b.second);
    };
    const auto allSame = [&](const auto& a, const auto& b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
    };
    return units_ == other.units_ && allSame(objects_, other.objects_) && allSame(meshes_, other.meshes_);
}

}  // namespace knotspan
