#include "model/analysis/border_cover.h"

#include <algorithm>

namespace knotspan {

BorderCover coverOf(const CoincidentEdges& edges, std::uint32_t side)
{
    const CoincidentEdge* edge = edges.edgeAlong(side);
    if (edge == nullptr)
        return {};
    const auto member = std::find_if(edge->members.begin(), edge->members.end(),
                                     [&](const EdgeMember& one) { return one.side == side; });
    if (member == edge->members.end())
        return {};
    BorderCover cover{static_cast<std::uint32_t>(edge->members.size()), 0};
    for (size_t k = 0; k + 1 < edge->cuts.size(); ++k) {
        if (!member->covers(edge->cuts[k].at, edge->cuts[k + 1].at))
            continue;
        std::uint32_t others = 0;
        for (const EdgeMember& other : edge->members)
            others += other.side != side && other.covers(edge->cuts[k].at, edge->cuts[k + 1].at) ? 1 : 0;
        cover.least = std::min(cover.least, others);
        cover.most = std::max(cover.most, others);
    }
    cover.least = std::min(cover.least, cover.most);
    return cover;
}

bool isClosedSide(const CoincidentEdges& edges, std::uint32_t side)
{
    return edges.isCollapsed(side) || coverOf(edges, side).least >= 1;
}

bool isManifoldSide(const CoincidentEdges& edges, std::uint32_t side)
{
    if (edges.isCollapsed(side))
        return true;
    const BorderCover cover = coverOf(edges, side);
    return cover.least == 1 && cover.most == 1;
}

}  // namespace knotspan
