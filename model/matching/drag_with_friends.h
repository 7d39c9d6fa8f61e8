// Keep friends for the objects of a scene: one drag of control points, from its press to its release. What
// the drag tools are made of where friends are to follow.
#pragma once

#include <memory>
#include <set>

#include "model/matching/keep_friends.h"
#include "model/scene/edit.h"

namespace knotspan {

struct ObjectPull {
    ObjectId object{};
    ControlPointIndex index;
    Vec3 position{};  // in model space
};

class DragWithFriends {
public:
    // Of the scene as it is when the drag begins. Friends are those that Friends finds within the
    // tolerances among visible objects and the pulled ones; hidden ones stay where they are.
    explicit DragWithFriends(Scene start, const FriendTolerances& tolerances = {});
    ~DragWithFriends();
    DragWithFriends(DragWithFriends&&) noexcept;
    DragWithFriends& operator=(DragWithFriends&&) noexcept;

    // Where a control point of the scene stood when the drag began, in model space.
    [[nodiscard]] Vec3 startOf(ObjectId object, ControlPointIndex index) const;

    // Turns the scene, as the last answer left it, into the one in which these points stand there and the
    // friends follow: what an earlier answer moved and this one does not is back where it started. Fails,
    // with a sentence that names the objects, where an edge cannot follow; the answers before still hold.
    // The first call looks for friends, of the pulled objects' surroundings only; others take no notice of
    // how large the scene is.
    [[nodiscard]] Result<Edit> pull(const std::vector<ObjectPull>& pulled);

private:
    struct Part;

    [[nodiscard]] Result<std::vector<PointMove>> follow(const std::vector<ObjectPull>& pulled) const;

    Scene start_;
    FriendTolerances tolerances_;
    std::unique_ptr<Part> part_;  // of the scene: what can have to do with the drag
    std::set<ObjectId> touched_;  // by the answers so far
};

}  // namespace knotspan
