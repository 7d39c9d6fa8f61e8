#include "model/matching/drag_with_friends.h"

#include <algorithm>
#include <cmath>

#include <glm/matrix.hpp>

#include "model/core/check.h"
#include "model/matching/neighbours.h"

namespace knotspan {

namespace {

// What follows is nearly always one of those that touch a pulled object. Those at the last step are only
// there so that all edges of the ones before are known.
constexpr int kSteps = 2;

bool isFinite(const Vec3& place)
{
    return std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
}

std::set<ObjectId> objectsOf(const std::vector<ObjectPull>& pulled)
{
    std::set<ObjectId> ids;
    for (const ObjectPull& pull : pulled)
        ids.insert(pull.object);
    return ids;
}

std::map<ObjectId, int> wholeScene(const Scene& scene, const std::set<ObjectId>& pulled)
{
    std::map<ObjectId, int> all;
    for (const auto& [id, object] : scene.objects())
        if (object->visible || pulled.count(id) != 0)
            all[id] = 0;
    return all;
}

SceneFriends friendsOf(const Scene& scene, const FriendTolerances& tolerances)
{
    SceneFriends friends(tolerances);
    friends.follow(scene, true);
    return friends;
}

std::vector<PlacedSurface> surfacesOf(const SceneFriends& friends)
{
    std::vector<PlacedSurface> surfaces;
    for (std::uint32_t k = 0; k < friends.objects().size(); ++k)
        surfaces.push_back(placed(*friends.object(k)));
    return surfaces;
}

std::vector<std::string> namesOf(const Scene& scene, const std::vector<ObjectId>& ids)
{
    std::vector<std::string> names;
    for (const ObjectId id : ids)
        names.push_back(nameOf(scene, id));
    return names;
}

}  // namespace

// Some of the objects, and the friends among them.
struct DragWithFriends::Part {
    std::set<ObjectId> pulled;
    std::map<ObjectId, int> steps;
    bool isWhole;
    SceneFriends friends;
    FriendKeeper keeper;

    Part(const Scene& scene, std::set<ObjectId> of, bool whole, const FriendTolerances& tolerances)
        : pulled(std::move(of)),
          steps(whole ? wholeScene(scene, pulled) : neighbours(scene, pulled, kSteps, tolerances.gap)),
          isWhole(whole),
          friends(friendsOf(partOf(scene, steps), tolerances)),
          keeper(surfacesOf(friends), friends.edges(), namesOf(scene, friends.objects()), tolerances.gap)
    {
    }

    [[nodiscard]] std::uint32_t number(ObjectId id) const
    {
        const std::vector<ObjectId>& ids = friends.objects();
        return static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    }

    // Whether all edges of whatever moves are edges of the part.
    [[nodiscard]] bool knowsAllOf(const std::vector<PointMove>& moves) const
    {
        return isWhole || std::all_of(moves.begin(), moves.end(), [this](const PointMove& move) {
                   return steps.at(friends.objects()[move.surface]) < kSteps;
               });
    }
};

DragWithFriends::DragWithFriends(Scene start, const FriendTolerances& tolerances)
    : start_(std::move(start)),
      tolerances_(tolerances)
{
}

DragWithFriends::~DragWithFriends() = default;
DragWithFriends::DragWithFriends(DragWithFriends&&) noexcept = default;
DragWithFriends& DragWithFriends::operator=(DragWithFriends&&) noexcept = default;

Result<std::vector<PointMove>> DragWithFriends::follow(const std::vector<ObjectPull>& pulled) const
{
    const auto tooFar = [] {
        return failure("The control point would go infinitely far away", "Drag it less far");
    };
    std::vector<PointMove> moves;
    for (const ObjectPull& pull : pulled) {
        const Mat4& transform = start_.find(pull.object)->transform;
        // The identity must not cost the last bit.
        const Vec3 local =
            transform == Mat4(1.0) ? pull.position : transformed(pull.position, glm::inverse(transform));
        if (!isFinite(local))
            return tooFar();
        moves.push_back({part_->number(pull.object), pull.index, local});
    }
    auto followed = part_->keeper.follow(moves);
    if (followed && !std::all_of(followed->begin(), followed->end(),
                                 [](const PointMove& move) { return isFinite(move.position); }))
        return tooFar();
    return followed;
}

Vec3 DragWithFriends::startOf(ObjectId object, ControlPointIndex index) const
{
    return controlPointInModel(*start_.find(object), index);
}

Result<Edit> DragWithFriends::pull(const std::vector<ObjectPull>& pulled)
{
    const std::set<ObjectId> ids = objectsOf(pulled);
    if (!part_ || part_->pulled != ids)
        part_ = std::make_unique<Part>(start_, ids, false, tolerances_);
    auto moves = follow(pulled);
    if (moves && !part_->knowsAllOf(*moves)) {
        part_ = std::make_unique<Part>(start_, ids, true, tolerances_);
        moves = follow(pulled);
    }
    if (!moves)
        return tl::unexpected(moves.error());

    Edit edit;
    for (const ObjectId id : touched_)
        edit.set(id, start_.find(id));
    std::map<std::uint32_t, std::vector<PointMove>> bySurface;
    for (const PointMove& move : *moves)
        bySurface[move.surface].push_back(move);
    for (const auto& [number, own] : bySurface) {
        const ObjectId id = part_->friends.objects()[number];
        auto moved = std::make_shared<SceneObject>(*start_.find(id));
        moved->surface = withMoves(moved->surface, number, own);
        edit.set(id, std::move(moved));
        touched_.insert(id);
    }
    return edit;
}

}  // namespace knotspan
