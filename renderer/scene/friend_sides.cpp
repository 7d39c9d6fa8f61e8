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

const std::vector<std::uint8_t>& FriendSides::of(const std::vector<Resident>& residents,
                                                 const ResidentChanges* log)
{
    const HeldResidents::Difference difference = held_.take(residents, log);
    if (difference.isEmpty())
        return sides_;
    if (difference.anew)
        friends_ = Friends(placedSurfaces(residents));
    else
        friends_.update(difference.changes);
    const std::vector<BorderNumbers> numbers = borderNumbers(placedSurfaces(residents));
    sides_.assign(numbers.empty() ? 0 : numbers.back().firstBorder + numbers.back().borderCount(), 0);
    for (const FriendEdge& edge : friends_.edges())
        if (edge.areFriends())
            for (const EdgePart& part : {edge.a, edge.b})
                note(part, held_[part.surface].surface, numbers[part.surface], sides_);
    return sides_;
}

}  // namespace knotspan
