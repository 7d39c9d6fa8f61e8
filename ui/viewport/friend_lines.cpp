#include "ui/viewport/friend_lines.h"

namespace knotspan {

namespace {

constexpr std::uint32_t kVermilion = 0xd55e00;
constexpr std::uint32_t kOrange = 0xe69f00;
constexpr std::uint32_t kSkyBlue = 0x56b4e9;
constexpr std::uint32_t kBluishGreen = 0x009e73;
constexpr std::uint32_t kReddishPurple = 0xcc79a7;
constexpr std::uint32_t kGrey = 0xa0a0a0;
constexpr std::uint32_t kChosen = 0xffffff;  // around the verdict's colour
constexpr double kWidthPx = 3;
constexpr double kChosenPx = 5;
constexpr double kAroundPx = 9;

EdgeLine lineOf(const SceneFriends& friends, const EdgePart& part, std::uint32_t colour, double widthPx)
{
    return {friends.objects()[part.surface], part, colour, widthPx};
}

void addLines(const SceneFriends& friends, size_t number, double widthPx, std::optional<std::uint32_t> colour,
              std::vector<EdgeLine>& to)
{
    const size_t edges = friends.edges().size();
    if (number >= edges) {
        to.push_back(
            lineOf(friends, friends.nakedEdges()[number - edges], colour.value_or(nakedColour()), widthPx));
        return;
    }
    const FriendEdge& edge = friends.edges()[number];
    const std::uint32_t used = colour.value_or(verdictColour(edge.continuity));
    to.push_back(lineOf(friends, edge.a, used, widthPx));
    if (edge.continuity == Continuity::none)
        to.push_back(lineOf(friends, edge.b, used, widthPx));
}

}  // namespace

std::uint32_t verdictColour(Continuity continuity)
{
    switch (continuity) {
    case Continuity::none:
        return kVermilion;
    case Continuity::g0:
        return kOrange;
    case Continuity::g1:
        return kSkyBlue;
    case Continuity::g2:
        return kBluishGreen;
    case Continuity::undetermined:
        break;
    }
    return kGrey;
}

std::uint32_t nakedColour()
{
    return kReddishPurple;
}

std::vector<EdgeLine> friendLines(const SceneFriends& friends)
{
    std::vector<EdgeLine> lines;
    const size_t edges = friends.edges().size();
    for (const bool smooth : {true, false})
        for (size_t k = 0; k < edges; ++k)
            if (friends.edges()[k].areFriends() == smooth)
                addLines(friends, k, kWidthPx, {}, lines);
    for (size_t k = 0; k < friends.nakedEdges().size(); ++k)
        addLines(friends, edges + k, kWidthPx, {}, lines);
    return lines;
}

std::vector<EdgeLine> chosenFriendLines(const SceneFriends& friends, size_t number)
{
    std::vector<EdgeLine> lines;
    addLines(friends, number, kAroundPx, kChosen, lines);
    addLines(friends, number, kChosenPx, {}, lines);
    return lines;
}

}  // namespace knotspan
