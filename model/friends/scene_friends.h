// The friends among the objects of a scene, by their ids. Follows a changing scene: edges of objects that are
// the same as before are not looked at again.
#pragma once

#include <optional>

#include "model/friends/friends.h"
#include "model/scene/scene.h"

namespace knotspan {

class SceneFriends {
public:
    explicit SceneFriends(const FriendTolerances& tolerances = {});

    // Takes the scene as it is now; hidden objects take part only where asked for. False: nothing that
    // counts changed.
    bool follow(const Scene& scene, bool hiddenToo = false);

    [[nodiscard]] const FriendTolerances& tolerances() const { return tolerances_; }
    void setTolerances(const FriendTolerances& tolerances);  // takes effect with the next follow()

    // Surfaces are numbers into objects().
    [[nodiscard]] const std::vector<FriendEdge>& edges() const { return friends_.edges(); }
    [[nodiscard]] const std::vector<EdgePart>& nakedEdges() const { return friends_.nakedEdges(); }
    [[nodiscard]] const std::vector<EdgePart>& shortEdges() const { return friends_.shortEdges(); }
    [[nodiscard]] const std::vector<ObjectId>& objects() const { return ids_; }
    [[nodiscard]] const SharedObject& object(std::uint32_t surface) const { return held_[surface]; }

private:
    // Where only these were exchanged since; nothing: others take part now.
    std::optional<bool> followExchanged(const std::vector<ObjectId>& exchanged, bool hiddenToo);

    FriendTolerances tolerances_;
    bool anew_ = true;
    Scene scene_;  // that was followed last
    bool hiddenToo_ = false;
    std::vector<ObjectId> ids_;
    std::vector<SharedObject> held_;
    Friends friends_;
};

// The surface, its transform and its trim loops, for as long as the object lives.
[[nodiscard]] PlacedSurface placed(const SceneObject& object);

// A parameter of the part as the surface's (u, v).
[[nodiscard]] Vec2 parametersOn(const SceneObject& object, const EdgePart& part, double parameter);

// The part's place in space at a parameter of it: a point of the edge in model space.
[[nodiscard]] Vec3 pointOn(const SceneObject& object, const EdgePart& part, double parameter);

// "u start", "u end", "v start", "v end", "loop 1 curve 2" (counted from 1): as people are told which edge is
// meant.
[[nodiscard]] std::string edgeName(const EdgePart& edge);

}  // namespace knotspan
