#include "model/analysis/edge_forming.h"

#include <algorithm>
#include <cmath>

namespace knotspan {

namespace {

class EdgeForming {
public:
    template <class IsFree>
    EdgeForming(const std::vector<SideOverlaps>& overlaps, std::uint32_t root, const IsFree& isFree)
        : overlaps_(overlaps)
    {
        add({root, 0, 1});
        // Members come while others are looked through.
        for (size_t k = 0; k < edge_.members.size(); ++k)
            for (const SideOverlap& overlap : overlaps_[edge_.members[k].side].overlaps)
                if (isFree(overlap.other) && !has(overlap.other))
                    add(continued(edge_.members[k], overlap));
    }

    [[nodiscard]] CoincidentEdge take()
    {
        std::sort(edge_.members.begin(), edge_.members.end(),
                  [](const EdgeMember& a, const EdgeMember& b) { return a.side < b.side; });
        return std::move(edge_);
    }

private:
    [[nodiscard]] bool has(std::uint32_t side) const
    {
        return std::any_of(edge_.members.begin(), edge_.members.end(),
                           [side](const EdgeMember& member) { return member.side == side; });
    }

    [[nodiscard]] static EdgeMember continued(const EdgeMember& from, const SideOverlap& overlap)
    {
        const double start = from.start + overlap.start * (from.end - from.start);
        const double end = from.start + overlap.end * (from.end - from.start);
        const double slope = (end - start) / (overlap.otherEnd - overlap.otherStart);
        return {overlap.other, start - overlap.otherStart * slope, start + (1 - overlap.otherStart) * slope};
    }

    void add(EdgeMember member)
    {
        std::vector<EdgeCut> cuts = edge_.cuts;
        const double near = kShortestPart * std::abs(member.end - member.start);
        const auto& ends = overlaps_[member.side].ends;
        member.start = cutAt(cuts, member.start, ends[0], near);
        member.end = cutAt(cuts, member.end, ends[1], near);
        std::sort(cuts.begin(), cuts.end(), [](const EdgeCut& a, const EdgeCut& b) { return a.at < b.at; });
        edge_.members.push_back(member);
        if (isFineEnough(cuts))
            edge_.cuts = std::move(cuts);
        else
            edge_.members.pop_back();
    }

    static double cutAt(std::vector<EdgeCut>& cuts, double at, std::uint32_t corner, double near)
    {
        for (const EdgeCut& cut : cuts)
            if (cut.corner == corner && std::abs(cut.at - at) < near)
                return cut.at;
        cuts.push_back({at, corner});
        return at;
    }

    [[nodiscard]] bool isFineEnough(const std::vector<EdgeCut>& cuts) const
    {
        return std::all_of(edge_.members.begin(), edge_.members.end(), [&](const EdgeMember& member) {
            const double low = std::min(member.start, member.end);
            const double high = std::max(member.start, member.end);
            const double shortest = 0.999 * kShortestPart * (high - low);
            bool fine = high > low;
            for (size_t k = 0; k + 1 < cuts.size(); ++k)
                if (cuts[k].at >= low && cuts[k + 1].at <= high)
                    fine = fine && cuts[k + 1].at - cuts[k].at >= shortest;
            return fine;
        });
    }

    const std::vector<SideOverlaps>& overlaps_;
    CoincidentEdge edge_;
};

}  // namespace

std::vector<CoincidentEdge> formEdges(const std::vector<std::uint32_t>& sides,
                                      const std::vector<SideOverlaps>& overlaps)
{
    std::vector<CoincidentEdge> edges;
    std::vector<char> taken(sides.size(), 0);
    const auto place = [&](std::uint32_t side) {
        return static_cast<size_t>(std::lower_bound(sides.begin(), sides.end(), side) - sides.begin());
    };
    for (size_t k = 0; k < sides.size(); ++k) {
        if (taken[k] != 0)
            continue;
        CoincidentEdge edge = EdgeForming(overlaps, sides[k], [&](std::uint32_t side) {
                                  return taken[place(side)] == 0;
                              }).take();
        for (const EdgeMember& member : edge.members)
            taken[place(member.side)] = 1;
        if (edge.members.size() > 1)
            edges.push_back(std::move(edge));
    }
    return edges;
}

}  // namespace knotspan
