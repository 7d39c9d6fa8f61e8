// CoincidentEdges: which two sides are one curve, and the edges that come of it.
#include <set>
#include <utility>

#include "model/analysis/bezier_curves.h"
#include "model/analysis/coincident_edges.h"

namespace knotspan {

namespace {

using Indices = std::vector<std::uint32_t>;

}  // namespace

// Its ends, and each group of corners within it once; the corner of the lowest number says where.
std::vector<CoincidentEdges::OnSide> CoincidentEdges::cornersOn(std::uint32_t side) const
{
    const BorderSide& along = sides_[side];
    std::vector<OnSide> corners = {{corners_.ownerOf(along.corners[0]), 0.0},
                                   {corners_.ownerOf(along.corners[1]), 1.0}};
    std::vector<Hit> hits = hits_[side];
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
        return a.corner != b.corner ? a.corner < b.corner : a.t < b.t;
    });
    for (const Hit& hit : hits) {
        const std::uint32_t owner = corners_.ownerOf(hit.corner);
        const bool known = std::any_of(corners.begin(), corners.end(), [&](const OnSide& other) {
            return other.owner == owner && std::abs(other.t - hit.t) < kShortestPart;
        });
        if (!known)
            corners.push_back({owner, hit.t});
    }
    return corners;
}

// Sides that share at least two corners with it, or one twice.
Indices CoincidentEdges::besides(std::uint32_t side) const
{
    Indices met;
    for (const OnSide& place : cornersOn(side)) {
        Indices here;
        corners_.forGroup(place.owner, [&](std::uint32_t corner) {
            here.insert(here.end(), sidesOfCorner_[corner].begin(), sidesOfCorner_[corner].end());
            here.insert(here.end(), sidesHitBy_[corner].begin(), sidesHitBy_[corner].end());
        });
        std::sort(here.begin(), here.end());
        met.insert(met.end(), here.begin(), std::unique(here.begin(), here.end()));
    }
    std::sort(met.begin(), met.end());
    Indices result;
    for (size_t k = 0; k + 1 < met.size(); ++k)
        if (met[k] == met[k + 1] && met[k] != side && !sides_[met[k]].collapsed &&
            (result.empty() || result.back() != met[k]))
            result.push_back(met[k]);
    return result;
}

void CoincidentEdges::dropOverlaps(const Indices& sides)
{
    for (const std::uint32_t side : sides) {
        for (const SideOverlap& overlap : overlaps_[side].overlaps)
            std::erase_if(overlaps_[overlap.other].overlaps,
                          [side](const SideOverlap& other) { return other.other == side; });
        overlaps_[side].overlaps.clear();
    }
}

void CoincidentEdges::findOverlaps(const Indices& sides)
{
    for (const std::uint32_t side : sides) {
        overlaps_[side].ends = {corners_.ownerOf(sides_[side].corners[0]),
                                corners_.ownerOf(sides_[side].corners[1])};
        if (sides_[side].collapsed)
            continue;
        for (const std::uint32_t other : besides(side))
            if (other > side || !std::binary_search(sides.begin(), sides.end(), other))
                compare(std::min(side, other), std::max(side, other));
    }
}

// Between two places that both sides go through, the furthest apart first.
void CoincidentEdges::compare(std::uint32_t a, std::uint32_t b)
{
    struct Meeting {
        double onA;
        double onB;
    };
    std::vector<Meeting> meetings;
    const auto cornersOnB = cornersOn(b);
    for (const OnSide& onA : cornersOn(a))
        for (const OnSide& onB : cornersOnB)
            if (onA.owner == onB.owner)
                meetings.push_back({onA.t, onB.t});
    std::sort(meetings.begin(), meetings.end(), [](const Meeting& x, const Meeting& y) {
        return x.onA != y.onA ? x.onA < y.onA : x.onB < y.onB;
    });
    std::vector<std::pair<Meeting, Meeting>> pairs;
    for (size_t i = 0; i < meetings.size(); ++i)
        for (size_t j = i + 1; j < meetings.size(); ++j)
            if (meetings[j].onA - meetings[i].onA >= kShortestPart &&
                std::abs(meetings[j].onB - meetings[i].onB) >= kShortestPart)
                pairs.emplace_back(meetings[i], meetings[j]);
    std::stable_sort(pairs.begin(), pairs.end(), [](const auto& x, const auto& y) {
        return x.second.onA - x.first.onA > y.second.onA - y.first.onA;
    });
    const double tolerance = std::max(tolerances_[sides_[a].surface], tolerances_[sides_[b].surface]);
    for (const auto& [from, to] : pairs) {
        if (!sameCurve(part(sides_[a].curve, from.onA, to.onA), part(sides_[b].curve, from.onB, to.onB),
                       tolerance))
            continue;
        const auto note = [this](std::uint32_t side, const SideOverlap& overlap) {
            auto& list = overlaps_[side].overlaps;
            const auto next = std::find_if(list.begin(), list.end(), [&](const SideOverlap& other) {
                return other.other > overlap.other;
            });
            list.insert(next, overlap);
        };
        const bool reversed = from.onB > to.onB;
        const Meeting& low = reversed ? to : from;
        const Meeting& high = reversed ? from : to;
        note(a, {b, from.onA, to.onA, from.onB, to.onB});
        note(b, {a, low.onB, high.onB, low.onA, high.onA});
        return;
    }
}

// With all sides that overlap them, directly or through others; increasing.
Indices CoincidentEdges::connected(Indices sides) const
{
    std::set<std::uint32_t> found(sides.begin(), sides.end());
    while (!sides.empty()) {
        const std::uint32_t side = sides.back();
        sides.pop_back();
        for (const SideOverlap& overlap : overlaps_[side].overlaps)
            if (found.insert(overlap.other).second)
                sides.push_back(overlap.other);
    }
    return {found.begin(), found.end()};
}

bool CoincidentEdges::joinEdges(const Indices& sides)
{
    std::vector<std::shared_ptr<const CoincidentEdge>> before;
    for (const std::uint32_t side : sides)
        before.push_back(std::exchange(edges_[side], nullptr));
    for (CoincidentEdge& edge : formEdges(sides, overlaps_)) {
        const auto shared = std::make_shared<const CoincidentEdge>(std::move(edge));
        for (const EdgeMember& member : shared->members)
            edges_[member.side] = shared;
    }
    for (size_t k = 0; k < sides.size(); ++k) {
        const CoincidentEdge* const now = edges_[sides[k]].get();
        if ((now == nullptr) != (before[k] == nullptr) || (now != nullptr && !(*now == *before[k])))
            return true;
    }
    return false;
}

}  // namespace knotspan
