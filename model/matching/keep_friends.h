// Keep friends: while control points near friend edges are pulled, those of the friends follow, so that the
// edges stay G1.
//
// Edges stay where they are unless they are pulled themselves; corners likewise. Curvatures are not kept, and
// edges that were G0 stay closed. That takes sides whose rows go with each other point by point, to the gap
// tolerance; elsewhere pulls are refused.
#pragma once

#include <memory>
#include <string>

#include "model/friends/friends.h"
#include "model/scene/control_point_editing.h"

namespace knotspan {

struct PointMove {
    std::uint32_t surface = 0;
    ControlPointIndex index;
    Vec3 position{};  // in the surface's own space
};

// The surface with those of the moves that are of it, surface number `number`. Positions are finite.
[[nodiscard]] NurbsSurface withMoves(const NurbsSurface& surface, std::uint32_t number,
                                     const std::vector<PointMove>& moves);

// Knows the surfaces as they are when it is made: make one when a drag begins and ask it for every place the
// pointer comes to. Surfaces are only looked at while it is made.
class FriendKeeper {
public:
    // `names` of the surfaces, for sentences; without, their numbers. `gap`: the tolerance the edges were
    // found with.
    FriendKeeper(const std::vector<PlacedSurface>& surfaces, const std::vector<FriendEdge>& edges,
                 std::vector<std::string> names = {}, double gap = FriendTolerances{}.gap);
    ~FriendKeeper();
    FriendKeeper(FriendKeeper&&) noexcept;
    FriendKeeper& operator=(FriendKeeper&&) noexcept;

    // The pulled points and all that follow, each once, by surface and index. Fails, with a sentence, where
    // an edge they shape cannot follow: its sides have different knots or control points along it, or too
    // many surfaces meet at a corner for the rows to agree. Each control point is pulled to one place only.
    [[nodiscard]] Result<std::vector<PointMove>> follow(const std::vector<PointMove>& pulled) const;

    // Indices of the edges (as given) that moves of these points change: those whose first two rows hold one
    // of them.
    [[nodiscard]] std::vector<size_t> touchedEdges(const std::vector<PointMove>& moves) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace knotspan
