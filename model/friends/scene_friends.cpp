#include "model/friends/scene_friends.h"

#include "model/geometry/evaluation.h"

namespace knotspan {

namespace {

PlacedSurface placed(const SharedObject& object)
{
    return {&object->surface, object->transform};
}

}  // namespace

SceneFriends::SceneFriends(const FriendTolerances& tolerances)
    : tolerances_(tolerances), friends_({}, tolerances)
{
}

void SceneFriends::setTolerances(const FriendTolerances& tolerances)
{
    anew_ = anew_ || tolerances != tolerances_;
    tolerances_ = tolerances;
}

bool SceneFriends::follow(const Scene& scene, bool hiddenToo)
{
    std::vector<ObjectId> ids;
    std::vector<SharedObject> objects;
    for (const auto& [id, object] : scene.objects())
        if (object->visible || hiddenToo) {
            ids.push_back(id);
            objects.push_back(object);
        }
    if (anew_ || ids != ids_) {
        std::vector<PlacedSurface> surfaces;
        for (const SharedObject& object : objects)
            surfaces.push_back(placed(object));
        friends_ = Friends(surfaces, tolerances_);
        anew_ = false;
        ids_ = std::move(ids);
        held_ = std::move(objects);
        return true;
    }
    std::vector<Friends::Change> changes;
    for (size_t k = 0; k < objects.size(); ++k)
        if (objects[k] != held_[k] && (objects[k]->surface != held_[k]->surface ||
                                       objects[k]->transform != held_[k]->transform))
            changes.push_back({static_cast<std::uint32_t>(k), placed(objects[k])});
    held_ = std::move(objects);
    if (!changes.empty())
        friends_.update(changes);
    return !changes.empty();
}

Vec3 pointOn(const SceneObject& object, const EdgePart& part, double parameter)
{
    const NurbsSurface& surface = object.surface;
    const bool alongV = part.side == Side::startU || part.side == Side::endU;
    const KnotVector& across = alongV ? surface.knotsU() : surface.knotsV();
    const bool atEnd = part.side == Side::endU || part.side == Side::endV;
    const double fixed = atEnd ? across.domainEnd() : across.domainStart();
    const Vec3 point = (alongV ? evaluate(surface, fixed, parameter) : evaluate(surface, parameter, fixed)).position;
    return Vec3(object.transform * Vec4(point, 1));
}

const char* sideName(Side side)
{
    constexpr const char* kNames[] = {"u start", "u end", "v start", "v end"};
    return kNames[static_cast<size_t>(side)];
}

}  // namespace knotspan
