// Who stands beside whom in a surface's net, across a seam too.
#pragma once

#include <optional>

#include "model/geometry/knot_insertion.h"
#include "model/sculpting/net_size.h"

namespace knotspan {

// A net is joined along u where its first and last points (0, j) and (countU - 1, j) coincide, to 1e-9 of its
// size: twins, on either side of the seam of a closed surface. A border is collapsed where all its points
// coincide: a pole. What treats each point by neighbours() and by its first() keeps seams and poles together.
class NetNeighbours {
public:
    // Looks at the net's borders only.
    explicit NetNeighbours(const NurbsSurface& surface);

    [[nodiscard]] bool isJoined(Direction direction) const
    {
        return direction == Direction::U ? joinedU_ : joinedV_;
    }

    // Along a direction, over the seam to the other side's; nothing beyond an open border.
    [[nodiscard]] std::optional<ControlPointIndex> next(ControlPointIndex index, Direction direction) const;
    [[nodiscard]] std::optional<ControlPointIndex> previous(ControlPointIndex index,
                                                            Direction direction) const;

    // Of a point's twins, and of a pole's points, the one that comes first.
    [[nodiscard]] ControlPointIndex first(ControlPointIndex index) const;

private:
    [[nodiscard]] int last(Direction direction) const
    {
        return (direction == Direction::U ? size_.countU : size_.countV) - 1;
    }

    NetSize size_;
    bool joinedU_ = false;
    bool joinedV_ = false;
    // The borders at the start and the end of u, and of v.
    bool collapsedU_[2] = {false, false};
    bool collapsedV_[2] = {false, false};
};

}  // namespace knotspan
