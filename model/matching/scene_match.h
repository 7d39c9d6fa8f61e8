// Match for the objects of a scene: an edge between two of them becomes smooth by one edit.
#pragma once

#include <set>

#include "model/friends/scene_friends.h"
#include "model/matching/match.h"
#include "model/scene/edit.h"

namespace knotspan {

// An edge and whose sides it has; the numbers of surfaces in `edge` do not count.
struct ObjectEdge {
    FriendEdge edge;
    ObjectId a{};
    ObjectId b{};
};

// Whether both lie on the same edges of the same objects, whichever part of those.
[[nodiscard]] bool isSameEdge(const ObjectEdge& x, const ObjectEdge& y);

// The edges of these objects, as Friends finds them within the tolerances; the others take part where they
// are visible. Objects that are not in the scene are passed over.
[[nodiscard]] std::vector<ObjectEdge> edgesOf(const Scene& scene, const std::set<ObjectId>& objects,
                                              const FriendTolerances& tolerances);

// The same edge in a scene that changed; nothing where its sides no longer run together there.
[[nodiscard]] std::optional<ObjectEdge> foundAgain(const Scene& scene, const ObjectEdge& edge,
                                                   const FriendTolerances& tolerances);
// Many of them at once; nothing in the place of one that is gone.
[[nodiscard]] std::vector<std::optional<ObjectEdge>>
foundAgain(const Scene& scene, const std::vector<ObjectEdge>& edges, const FriendTolerances& tolerances);

// Its number among the friends' edges(); nothing where they do not have it.
[[nodiscard]] std::optional<size_t> numberAmong(const SceneFriends& friends, const ObjectEdge& edge);

struct SceneMatch {
    MatchProposal proposal;
    Edit edit;  // empty where nothing has to move
};

// Objects keep their parametrization, so trim loops stay right. Fails as matchEdge() does, and where an
// object is gone.
[[nodiscard]] Result<SceneMatch> matchInScene(const Scene& scene, const ObjectEdge& edge, Continuity wanted,
                                              MatchSides move, const FriendTolerances& tolerances);

// What a match does to the edges beside the one that it mends.
struct SideEffects {
    struct Worse {
        ObjectEdge edge;                  // as it is
        std::optional<Continuity> after;  // nothing: its sides part
    };
    std::vector<Worse> worse;  // the worst first
    // Parts of edges that become naked, except those of `worse` whose sides part.
    struct Naked {
        ObjectId object{};
        EdgePart part;
    };
    std::vector<Naked> naked;
    [[nodiscard]] bool isEmpty() const { return worse.empty() && naked.empty(); }
};
// `scene` is the one before.
[[nodiscard]] SideEffects sideEffects(const Scene& scene, const ObjectEdge& edge, const SceneMatch& match,
                                      const FriendTolerances& tolerances);

// "u end of "Bow" and v start of "Side"": how people are told which edge is meant.
[[nodiscard]] std::string describe(const Scene& scene, const ObjectEdge& edge);

}  // namespace knotspan
