#include "renderer/measurement/closed_model.h"

#include <algorithm>

#include "model/analysis/coincident_edges.h"

namespace knotspan {

namespace {

// Whether the other members cover all of this one's part of the edge.
bool isCovered(const EdgeMember& member, const CoincidentEdge& edge)
{
    std::vector<std::pair<double, double>> parts;
    for (const EdgeMember& other : edge.members)
        if (other.side != member.side)
            parts.push_back(std::minmax(other.start, other.end));
    std::sort(parts.begin(), parts.end());
    const auto [start, end] = std::minmax(member.start, member.end);
    double reached = start;
    for (const auto& [low, high] : parts)
        if (low <= reached)
            reached = std::max(reached, high);
    return reached >= end;
}

bool isClosedSide(const CoincidentEdges& edges, std::uint32_t side)
{
    if (edges.isCollapsed(side))
        return true;
    const CoincidentEdge* edge = edges.edgeAlong(side);
    if (edge == nullptr)
        return false;
    const auto member = std::find_if(edge->members.begin(), edge->members.end(),
                                     [&](const EdgeMember& one) { return one.side == side; });
    return member != edge->members.end() && isCovered(*member, *edge);
}

}  // namespace

bool isClosedModel(const Scene& scene)
{
    std::vector<PlacedSurface> surfaces;
    for (const auto& [id, object] : scene.objects())
        if (object->visible)
            surfaces.push_back({&object->surface, object->transform});
    if (surfaces.empty())
        return false;
    const CoincidentEdges edges(surfaces);
    for (std::uint32_t side = 0; side < edges.sideCount(); ++side)
        if (!isClosedSide(edges, side))
            return false;
    return true;
}

}  // namespace knotspan
