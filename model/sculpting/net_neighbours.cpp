#include "model/sculpting/net_neighbours.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace knotspan {

namespace {

ControlPointIndex with(ControlPointIndex index, Direction direction, int k)
{
    (direction == Direction::U ? index.i : index.j) = k;
    return index;
}

}  // namespace

NetNeighbours::NetNeighbours(const NurbsSurface& surface) : size_(netSizeOf(surface))
{
    const double near = 1e-9 * surface.bounds().diagonal();
    const auto coincide = [&](ControlPointIndex a, ControlPointIndex b) {
        return glm::distance(surface.controlPoint(a.i, a.j).position,
                             surface.controlPoint(b.i, b.j).position) <= near;
    };
    const auto forAll = [](int count, const auto& holds) {
        for (int k = 0; k < count; ++k)
            if (!holds(k))
                return false;
        return true;
    };
    const int lastU = last(Direction::U);
    const int lastV = last(Direction::V);
    joinedU_ = lastU > 1 && forAll(size_.countV, [&](int j) { return coincide({0, j}, {lastU, j}); });
    joinedV_ = lastV > 1 && forAll(size_.countU, [&](int i) { return coincide({i, 0}, {i, lastV}); });
    for (const int end : {0, 1}) {
        const int i = end * lastU;
        const int j = end * lastV;
        collapsedU_[end] = forAll(size_.countV, [&](int k) { return coincide({i, 0}, {i, k}); });
        collapsedV_[end] = forAll(size_.countU, [&](int k) { return coincide({0, j}, {k, j}); });
    }
}

std::optional<ControlPointIndex> NetNeighbours::next(ControlPointIndex index, Direction direction) const
{
    const int k = direction == Direction::U ? index.i : index.j;
    if (k < last(direction))
        return with(index, direction, k + 1);
    return isJoined(direction) ? std::optional(with(index, direction, 1)) : std::nullopt;
}

std::optional<ControlPointIndex> NetNeighbours::previous(ControlPointIndex index, Direction direction) const
{
    const int k = direction == Direction::U ? index.i : index.j;
    if (k > 0)
        return with(index, direction, k - 1);
    return isJoined(direction) ? std::optional(with(index, direction, last(direction) - 1)) : std::nullopt;
}

ControlPointIndex NetNeighbours::first(ControlPointIndex index) const
{
    const int lastU = last(Direction::U);
    const int lastV = last(Direction::V);
    if (joinedU_ && index.i == lastU)
        index.i = 0;
    if (joinedV_ && index.j == lastV)
        index.j = 0;
    if ((index.i == 0 && collapsedU_[0]) || (index.i == lastU && collapsedU_[1]))
        index.j = 0;
    if ((index.j == 0 && collapsedV_[0]) || (index.j == lastV && collapsedV_[1]))
        index.i = 0;
    return index;
}

}  // namespace knotspan
