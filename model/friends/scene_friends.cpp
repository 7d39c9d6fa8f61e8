#include "model/friends/scene_friends.h"

#include <algorithm>
#include <utility>

#include "model/geometry/evaluation.h"

namespace knotspan {

SceneFriends::SceneFriends(const FriendTolerances& tolerances)
    : tolerances_(tolerances),
      friends_({}, tolerances)
{
}

void SceneFriends::setTolerances(const FriendTolerances& tolerances)
{
    anew_ = anew_ || tolerances != tolerances_;
    tolerances_ = tolerances;
}

namespace {

bool haveSameLoops(const SharedObject& x, const SharedObject& y)
{
    return x == y || x->trimLoops == y->trimLoops;
}

bool standAlike(const SharedObject& x, const SharedObject& y)
{
    return x == y || (x->surface == y->surface && x->transform == y->transform);
}

}  // namespace

std::optional<bool> SceneFriends::followExchanged(const std::vector<ObjectId>& exchanged, bool hiddenToo)
{
    std::vector<std::pair<std::uint32_t, SharedObject>> others;
    for (const ObjectId id : exchanged) {
        const SharedObject object = scene_.find(id);
        const auto place = std::lower_bound(ids_.begin(), ids_.end(), id);
        const bool was = place != ids_.end() && *place == id;
        const bool is = object != nullptr && (object->visible || hiddenToo);
        const auto index = static_cast<std::uint32_t>(place - ids_.begin());
        if (was != is || (is && !haveSameLoops(object, held_[index])))
            return std::nullopt;
        if (is)
            others.emplace_back(index, object);
    }
    std::vector<Friends::Change> changes;
    for (const auto& [index, object] : others) {
        if (!standAlike(object, held_[index]))
            changes.push_back({index, placed(*object)});
        held_[index] = object;
    }
    if (!changes.empty())
        friends_.update(changes);
    return !changes.empty();
}

bool SceneFriends::follow(const Scene& scene, bool hiddenToo)
{
    const auto exchanged = scene.changedSince(scene_);
    scene_ = scene;
    const bool sameWish = std::exchange(hiddenToo_, hiddenToo) == hiddenToo;
    if (exchanged && sameWish && !anew_)
        if (const auto changed = followExchanged(*exchanged, hiddenToo))
            return *changed;
    std::vector<ObjectId> ids;
    std::vector<SharedObject> objects;
    for (const auto& [id, object] : scene.objects())
        if (object->visible || hiddenToo) {
            ids.push_back(id);
            objects.push_back(object);
        }
    if (anew_ || ids != ids_ ||
        !std::equal(objects.begin(), objects.end(), held_.begin(), held_.end(), haveSameLoops)) {
        std::vector<PlacedSurface> surfaces;
        for (const SharedObject& object : objects)
            surfaces.push_back(placed(*object));
        friends_ = Friends(surfaces, tolerances_);
        anew_ = false;
        ids_ = std::move(ids);
        held_ = std::move(objects);
        return true;
    }
    std::vector<Friends::Change> changes;
    for (size_t k = 0; k < objects.size(); ++k)
        if (!standAlike(objects[k], held_[k]))
            changes.push_back({static_cast<std::uint32_t>(k), placed(*objects[k])});
    held_ = std::move(objects);
    if (!changes.empty())
        friends_.update(changes);
    return !changes.empty();
}

PlacedSurface placed(const SceneObject& object)
{
    return {&object.surface, object.transform, &object.trimLoops};
}

Vec2 parametersOn(const SceneObject& object, const EdgePart& part, double parameter)
{
    if (part.trim)
        return object.trimLoops[part.trim->loop].curves[part.trim->curve].evaluate(parameter);
    const bool alongV = part.side == Side::startU || part.side == Side::endU;
    const KnotVector& across = alongV ? object.surface.knotsU() : object.surface.knotsV();
    const bool atEnd = part.side == Side::endU || part.side == Side::endV;
    const double fixed = atEnd ? across.domainEnd() : across.domainStart();
    return alongV ? Vec2(fixed, parameter) : Vec2(parameter, fixed);
}

Vec3 pointOn(const SceneObject& object, const EdgePart& part, double parameter)
{
    const Vec2 at = parametersOn(object, part, parameter);
    return transformed(evaluate(object.surface, at.x, at.y).position, object.transform);
}

std::string edgeName(const EdgePart& edge)
{
    if (edge.trim)
        return "loop " + std::to_string(edge.trim->loop + 1) + " curve " +
               std::to_string(edge.trim->curve + 1);
    constexpr const char* kSides[] = {"u start", "u end", "v start", "v end"};
    return kSides[static_cast<size_t>(edge.side)];
}

}  // namespace knotspan
