#include "renderer/scene/shared_edges.h"

#include <algorithm>
#include <cstring>
#include <unordered_map>
#include <utility>

namespace knotspan {

namespace {

bool covers(const EdgeMember& member, const EdgeCut& from, const EdgeCut& to)
{
    return std::min(member.start, member.end) <= from.at && std::max(member.start, member.end) >= to.at;
}

// 0 and 1 at the member's ends, to the bit.
float parameterAt(const EdgeMember& member, const EdgeCut& cut)
{
    return static_cast<float>((cut.at - member.start) / (member.end - member.start));
}

const EdgeMember& memberOf(const CoincidentEdge& edge, std::uint32_t side)
{
    return *std::find_if(edge.members.begin(), edge.members.end(),
                         [side](const EdgeMember& member) { return member.side == side; });
}

bool isReversed(const EdgeMember& member)
{
    return member.start > member.end;
}

bool joinsTwoWholes(const CoincidentEdge& edge)
{
    return edge.members.size() == 2 && edge.cuts.size() == 2;
}

}  // namespace

SharedEdges::SharedEdges(const std::vector<PlacedSurface>& surfaces) : edges_(surfaces)
{
    for (const BorderNumbers& numbers : edges_.numbers())
        for (std::uint32_t k = 0; k < numbers.borderCount(); ++k)
            names_.push_back(numbers.sideName(k));
    makeTables();
}

std::optional<BorderChanges> SharedEdges::update(const std::vector<CoincidentEdges::Change>& changes)
{
    if (!edges_.update(changes))
        return std::nullopt;
    BorderChanges changed;
    if (updateEntries(changed))
        return changed;
    changed = {std::move(tables_), {}, {}};
    makeTables();
    return changed;
}

bool SharedEdges::updateEntries(BorderChanges& changes)
{
    const CoincidentEdges::Touched& touched = edges_.touched();
    const auto isOrWasInPieces = [this](std::uint32_t side) {
        return isInPieces(side) || (tables_.sides[side].flags & BORDER_KIND) == BORDER_PIECES;
    };
    if (touched.all || std::any_of(touched.sides.begin(), touched.sides.end(), isOrWasInPieces))
        return false;
    for (const std::uint32_t side : touched.sides) {
        gpu::BorderSide entry = entryOf(side);
        entry.flags |= isFriendly(side) ? BORDER_FRIEND : 0U;
        const gpu::BorderSide before = std::exchange(tables_.sides[side], entry);
        if (std::memcmp(&before, &entry, sizeof(entry)) != 0)
            changes.sides.push_back(side);
    }
    for (const std::uint32_t corner : touched.corners) {
        const std::uint32_t name = edges_.corners().nameOf(edges_.corners().ownerOf(corner));
        if (std::exchange(tables_.corners[corner], name) != name)
            changes.corners.push_back(corner);
    }
    return true;
}

bool SharedEdges::isInPieces(std::uint32_t side) const
{
    const CoincidentEdge* const edge = edges_.edgeAlong(side);
    return edge != nullptr && !edges_.isCollapsed(side) && !joinsTwoWholes(*edge);
}

gpu::BorderSide SharedEdges::entryOf(std::uint32_t side) const
{
    const CoincidentEdge* const edge = edges_.edgeAlong(side);
    if (edges_.isCollapsed(side))
        return {0, BORDER_COLLAPSED};
    if (edge == nullptr)
        return {0, BORDER_OPEN};
    const bool owns = edge->members[0].side == side;
    const bool reversed = isReversed(edge->members[0]) != isReversed(edge->members[1]);
    return {names_[edge->members[owns ? 1 : 0].side],
            BORDER_WHOLE | (owns ? BORDER_OWNER : 0) | (reversed ? BORDER_REVERSED : 0)};
}

std::optional<BorderTables> SharedEdges::setFriends(const std::vector<std::uint8_t>& sides)
{
    if (sides == friends_)
        return std::nullopt;
    BorderTables before = tables_;
    friends_ = sides;
    markFriends();
    return before;
}

bool SharedEdges::isFriendly(std::uint32_t side) const
{
    const bool told = friends_.size() == edges_.sideCount();
    const CoincidentEdge* const edge = edges_.edgeAlong(side);
    if (!told)
        return edge != nullptr;
    if (edge == nullptr)
        return friends_[side] != 0;
    return std::all_of(edge->members.begin(), edge->members.end(),
                       [&](const EdgeMember& member) { return friends_[member.side] != 0; });
}

void SharedEdges::markFriends()
{
    for (std::uint32_t side = 0; side < edges_.sideCount(); ++side) {
        tables_.sides[side].flags &= ~BORDER_FRIEND;
        tables_.sides[side].flags |= isFriendly(side) ? BORDER_FRIEND : 0U;
    }
}

void SharedEdges::makeTables()
{
    tables_ = {};
    const CornerGroups& corners = edges_.corners();
    for (std::uint32_t corner = 0; corner < corners.count(); ++corner)
        tables_.corners.push_back(corners.nameOf(corners.ownerOf(corner)));

    std::unordered_map<const CoincidentEdge*, std::uint32_t> firstUses;
    for (std::uint32_t side = 0; side < edges_.sideCount(); ++side) {
        if (!isInPieces(side)) {
            tables_.sides.push_back(entryOf(side));
            continue;
        }
        const CoincidentEdge* const edge = edges_.edgeAlong(side);
        const auto [found, isNew] =
            firstUses.try_emplace(edge, static_cast<std::uint32_t>(tables_.uses.size()));
        if (isNew)
            addUses(*edge);
        addPieces(side, *edge, found->second);
    }
    markFriends();
}

// Those of an edge's pieces, one behind the other.
void SharedEdges::addUses(const CoincidentEdge& edge)
{
    for (size_t k = 0; k + 1 < edge.cuts.size(); ++k)
        for (const EdgeMember& member : edge.members)
            if (covers(member, edge.cuts[k], edge.cuts[k + 1]))
                tables_.uses.push_back({names_[member.side], std::abs(parameterAt(member, edge.cuts[k + 1]) -
                                                                      parameterAt(member, edge.cuts[k]))});
}

void SharedEdges::addPieces(std::uint32_t side, const CoincidentEdge& edge, std::uint32_t firstUse)
{
    const EdgeMember& own = memberOf(edge, side);
    std::vector<gpu::BorderPiece> pieces;
    for (size_t k = 0; k + 1 < edge.cuts.size(); ++k) {
        const EdgeCut& low = edge.cuts[k];
        const EdgeCut& high = edge.cuts[k + 1];
        const auto inPiece = [&](const EdgeMember& member) { return covers(member, low, high); };
        const auto count =
            static_cast<std::uint32_t>(std::count_if(edge.members.begin(), edge.members.end(), inPiece));
        if (inPiece(own)) {
            const EdgeMember& owner = *std::find_if(edge.members.begin(), edge.members.end(), inPiece);
            const EdgeCut& start = isReversed(own) ? high : low;
            const EdgeCut& end = isReversed(own) ? low : high;
            pieces.push_back({parameterAt(own, start), parameterAt(own, end), names_[owner.side],
                              parameterAt(owner, start), parameterAt(owner, end),
                              edges_.corners().nameOf(start.corner), firstUse, count});
        }
        firstUse += count;
    }
    if (isReversed(own))
        std::reverse(pieces.begin(), pieces.end());
    tables_.sides.push_back(
        {static_cast<std::uint32_t>(tables_.pieces.size()),
         BORDER_PIECES | static_cast<std::uint32_t>(pieces.size()) << BORDER_COUNT_SHIFT});
    tables_.pieces.insert(tables_.pieces.end(), pieces.begin(), pieces.end());
}

}  // namespace knotspan
