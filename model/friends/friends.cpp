#include "model/friends/friends.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/core/check.h"
#include "model/friends/box_tree.h"
#include "model/friends/edge_matching.h"
#include "model/friends/meeting_verdict.h"

namespace knotspan {

const char* continuityName(Continuity continuity)
{
    switch (continuity) {
    case Continuity::none:
        return "none";
    case Continuity::g0:
        return "G0";
    case Continuity::g1:
        return "G1";
    case Continuity::g2:
        return "G2";
    case Continuity::undetermined:
        break;
    }
    return "undetermined";
}

int smoothnessRank(Continuity continuity)
{
    switch (continuity) {
    case Continuity::none:
        return 0;
    case Continuity::undetermined:
        return 1;
    case Continuity::g0:
        return 2;
    case Continuity::g1:
        return 3;
    case Continuity::g2:
        break;
    }
    return 4;
}

FriendTolerances defaultTolerances(bool imported)
{
    FriendTolerances tolerances;
    if (imported)
        tolerances.angleDeg = 0.5;
    return tolerances;
}

namespace {

using Indices = std::vector<std::uint32_t>;

void sortUnique(Indices& indices)
{
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
}

// Of the edge's length between two of its parameters; what counts is not the last digit.
double lengthBetween(const EdgeStrip& strip, double from, double to)
{
    double length = 0;
    for (const EdgePiece& piece : strip.pieces) {
        const double share = (std::min(to, piece.to) - std::max(from, piece.from)) / (piece.to - piece.from);
        length += std::max(share, 0.0) * piece.length;
    }
    return length;
}

}  // namespace

// Edges are numbered surface after surface.
struct Friends::State {
    FriendTolerances tolerances;
    std::vector<std::uint32_t> firstEdges;  // by surface, and one more
    std::vector<EdgeStrip> strips;
    BoxTree tree;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<FriendEdge>> meetings;
    std::vector<Indices> partners;                  // by edge: with whom it has meetings
    std::vector<std::vector<EdgePart>> nakedParts;  // by edge
    std::vector<std::uint8_t> isTooShort;           // by edge
    std::vector<FriendEdge> edges;
    std::vector<EdgePart> naked;
    std::vector<EdgePart> tooShort;

    // No longer than three tolerances: a point, as far as anybody can tell.
    [[nodiscard]] bool isPoint(const EdgeStrip& strip) const
    {
        const MatchingLengths lengths = matchingLengths(strip, strip, tolerances.gap);
        return !(strip.length() > lengths.reach) || !std::isfinite(strip.length());
    }

    [[nodiscard]] Box reachOf(std::uint32_t edge) const
    {
        const EdgeStrip& strip = strips[edge];
        if (isPoint(strip))
            return {};
        const Vec3 reach(matchingLengths(strip, strip, tolerances.gap).reach);
        return {strip.box.low - reach, strip.box.high + reach};
    }

    // Whether an edge of it moved; those that did are added.
    void setSurface(std::uint32_t index, const PlacedSurface& placed, Indices& moved)
    {
        auto made = edgeStrips(index, placed, 0.001 * tolerances.gap);
        const std::uint32_t first = firstEdges[index];
        check(made.size() == firstEdges[index + 1] - first, "a changed surface has as many edges as before");
        for (std::uint32_t k = 0; k < made.size(); ++k) {
            EdgeStrip& strip = strips[first + k];
            if (strip.sameAs(made[k]))
                continue;
            strip = std::move(made[k]);
            moved.push_back(first + k);
        }
    }

    void compare(std::uint32_t first, std::uint32_t second)
    {
        const EdgeStrip& a = strips[first];
        const EdgeStrip& b = strips[second];
        const MatchingLengths lengths = matchingLengths(a, b, tolerances.gap);
        std::vector<FriendEdge> found;
        for (const MatchedRun& run : matchedRuns(a, b, lengths))
            found.push_back(meetingOf(a, b, run, lengths, tolerances));
        if (found.empty())
            return;
        std::stable_sort(found.begin(), found.end(),
                         [](const FriendEdge& x, const FriendEdge& y) { return x.a.from < y.a.from; });
        meetings[{first, second}] = std::move(found);
        partners[first].push_back(second);
        if (first != second)
            partners[second].push_back(first);
    }

    // All meetings of these edges anew; `moved` increases.
    void lookAgain(const Indices& moved)
    {
        Indices touched = moved;
        for (const std::uint32_t edge : moved) {
            for (const std::uint32_t partner : partners[edge]) {
                meetings.erase({std::min(edge, partner), std::max(edge, partner)});
                touched.push_back(partner);
                if (partner != edge)
                    std::erase(partners[partner], edge);
            }
            partners[edge].clear();
        }
        for (const std::uint32_t edge : moved) {
            const Box box = reachOf(edge);
            if (box.isEmpty())
                continue;
            tree.touching(box, [&](std::uint32_t other) {
                if (other >= edge || !std::binary_search(moved.begin(), moved.end(), other))
                    compare(std::min(edge, other), std::max(edge, other));
            });
            touched.insert(touched.end(), partners[edge].begin(), partners[edge].end());
        }
        sortUnique(touched);
        for (const std::uint32_t edge : moved) {
            const EdgeStrip& strip = strips[edge];
            isTooShort[edge] = isPoint(strip) && strip.length() > 1e-9 * strip.size ? 1 : 0;
        }
        for (const std::uint32_t edge : touched)
            findNaked(edge);
        list();
    }

    void findNaked(std::uint32_t edge)
    {
        const EdgeStrip& strip = strips[edge];
        auto& parts = nakedParts[edge];
        parts.clear();
        if (isPoint(strip))
            return;
        std::vector<std::pair<double, double>> covered;
        for (const std::uint32_t partner : partners[edge])
            for (const FriendEdge& meeting : meetings.at({std::min(edge, partner), std::max(edge, partner)}))
                for (const EdgePart& part : {meeting.a, meeting.b})
                    if (part.isOnSameEdge(strip.edge))
                        covered.emplace_back(part.from, part.to);
        const double end = strip.pieces.back().to;
        covered.emplace_back(end, end);
        std::sort(covered.begin(), covered.end());
        const double least = matchingLengths(strip, strip, tolerances.gap).shortest;
        double from = strip.pieces.front().from;
        for (const auto& [start, stop] : covered) {
            if (start > from && lengthBetween(strip, from, start) >= least)
                parts.push_back({strip.edge.surface, strip.edge.side, from, start, strip.edge.trim});
            from = std::max(from, stop);
        }
    }

    void list()
    {
        edges.clear();
        for (const auto& [pair, found] : meetings)
            edges.insert(edges.end(), found.begin(), found.end());
        tooShort.clear();
        for (size_t edge = 0; edge < strips.size(); ++edge)
            if (isTooShort[edge] != 0)
                tooShort.push_back(strips[edge].edge);
        naked.clear();
        for (const auto& parts : nakedParts)
            naked.insert(naked.end(), parts.begin(), parts.end());
    }

    void plant()
    {
        std::vector<Box> boxes;
        for (std::uint32_t edge = 0; edge < strips.size(); ++edge)
            boxes.push_back(reachOf(edge));
        tree = BoxTree(std::move(boxes));
    }
};

Friends::Friends(const std::vector<PlacedSurface>& surfaces, const FriendTolerances& tolerances)
    : state_(std::make_unique<State>())
{
    state_->tolerances = tolerances;
    size_t count = 0;
    for (const PlacedSurface& placed : surfaces) {
        state_->firstEdges.push_back(static_cast<std::uint32_t>(count));
        count += edgeCount(placed);
    }
    state_->firstEdges.push_back(static_cast<std::uint32_t>(count));
    state_->strips.resize(count);
    state_->partners.resize(count);
    state_->nakedParts.resize(count);
    state_->isTooShort.resize(count);
    Indices all;
    for (std::uint32_t index = 0; index < surfaces.size(); ++index)
        state_->setSurface(index, surfaces[index], all);
    state_->plant();
    state_->lookAgain(all);
}

Friends::~Friends() = default;
Friends::Friends(Friends&&) noexcept = default;
Friends& Friends::operator=(Friends&&) noexcept = default;

void Friends::update(const std::vector<Change>& changes)
{
    State& state = *state_;
    Indices moved;
    for (const Change& change : changes) {
        check(change.index + 1 < state.firstEdges.size(), "a changed surface is one of those given at first");
        state.setSurface(change.index, change.placed, moved);
    }
    sortUnique(moved);
    if (moved.empty())
        return;
    if (moved.size() > state.strips.size() / 4)
        state.plant();
    else
        for (const std::uint32_t edge : moved)
            state.tree.move(edge, state.reachOf(edge));
    state.lookAgain(moved);
}

const std::vector<FriendEdge>& Friends::edges() const
{
    return state_->edges;
}

const std::vector<EdgePart>& Friends::nakedEdges() const
{
    return state_->naked;
}

const std::vector<EdgePart>& Friends::shortEdges() const
{
    return state_->tooShort;
}

}  // namespace knotspan
