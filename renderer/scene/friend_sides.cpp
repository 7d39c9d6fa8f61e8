#include "renderer/scene/friend_sides.h"

namespace knotspan {

namespace {

// The sides of one edge that lie within the part.
void note(const EdgePart& part, const NurbsSurface& surface, const BorderNumbers& numbers,
          std::vector<std::uint8_t>& sides)
{
    const bool alongV = part.side == Side::startU || part.side == Side::endU;
    const KnotVector& knots = alongV ? surface.knotsV() : surface.knotsU();
    std::uint32_t number = numbers.firstBorder;
    if (part.side != Side::startU)
        number += numbers.spansV;
    if (!alongV)
        number += numbers.spansV;
    if (part.side == Side::endV)
        number += numbers.spansU;
    const double reach = 1e-6 * (knots.domainEnd() - knots.domainStart());
    for (const int span : knots.spans()) {
        if (knots[span] >= part.from - reach && knots[span + 1] <= part.to + reach)
            sides[number] = 1;
        ++number;
    }
}

}  // namespace

bool FriendSides::follow(const std::vector<Resident>& residents)
{
    bool anew = held_.size() != residents.size();
    std::vector<Friends::Change> changes;
    for (size_t k = 0; k < residents.size() && !anew; ++k) {
        anew = !isSameShape(held_[k]->surface, residents[k].object->surface);
        if (held_[k] != residents[k].object)
            changes.push_back({static_cast<std::uint32_t>(k), placedSurface(*residents[k].object)});
    }
    if (!anew && changes.empty())
        return false;
    held_.clear();
    for (const Resident& resident : residents)
        held_.push_back(resident.object);
    if (anew)
        friends_ = Friends(placedSurfaces(residents));
    else
        friends_.update(changes);
    return true;
}

const std::vector<std::uint8_t>& FriendSides::of(const std::vector<Resident>& residents)
{
    if (!follow(residents))
        return sides_;
    const std::vector<BorderNumbers> numbers = borderNumbers(placedSurfaces(residents));
    sides_.assign(numbers.empty() ? 0 : numbers.back().firstBorder + numbers.back().borderCount(), 0);
    for (const FriendEdge& edge : friends_.edges())
        if (edge.areFriends())
            for (const EdgePart& part : {edge.a, edge.b})
                note(part, held_[part.surface]->surface, numbers[part.surface], sides_);
    return sides_;
}

}  // namespace knotspan
