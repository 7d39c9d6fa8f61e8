#include "model/trimming/loop_clipping.h"

#include <algorithm>
#include <cmath>

#include "model/trimming/loop_chains.h"

namespace knotspan {

namespace {

constexpr double kNothing = 1e-11;        // of the domain
constexpr double kRoundingBeyond = 1e-6;  // of the domain: what reaches beyond it by less does not

Vec2 lowOf(const NurbsSurface& surface)
{
    return {surface.knotsU().domainStart(), surface.knotsV().domainStart()};
}

Vec2 highOf(const NurbsSurface& surface)
{
    return {surface.knotsU().domainEnd(), surface.knotsV().domainEnd()};
}

class Clipping {
public:
    Clipping(const HalfPlane& half, double nothing) : half_(half), nothing_(nothing)
    {
        lines_.places[half.axis] = {half.at};
        lines_.nothing = Vec2(nothing);
    }

    void add(const LoopChain& chain)
    {
        double least = 1e300;
        double most = -1e300;
        for (const LoopArc& part : chain)
            for (const TrimPoint& point : part.arc.points) {
                least = std::min(least, beyond(point.position));
                most = std::max(most, beyond(point.position));
            }
        if (most <= nothing_)
            kept_.push_back(chain);
        else if (least < -nothing_)
            cut(chain);
    }

    std::vector<LoopChain> taken()
    {
        link();
        return std::move(kept_);
    }

private:
    // How far on the side that goes.
    [[nodiscard]] double beyond(const Vec2& place) const
    {
        return half_.below ? place[half_.axis] - half_.at : half_.at - place[half_.axis];
    }

    // The parts of an arc on the side that stays; an empty chain stands for one that goes.
    void addParts(const LoopArc& part, std::vector<LoopChain>& runs)
    {
        const std::vector<TrimArc> pieces = cutArcs(part.arc, lines_);
        for (size_t k = 0; k < pieces.size();) {
            const bool stays = staysAs(pieces[k]);
            size_t last = k;
            while (last + 1 < pieces.size() && staysAs(pieces[last + 1]) == stays)
                ++last;
            if (stays)
                runs.back().push_back(between(part, pieces[k], pieces[last]));
            else if (!runs.back().empty())
                runs.emplace_back();
            anyGoes_ = anyGoes_ || !stays;
            k = last + 1;
        }
    }
    [[nodiscard]] bool staysAs(const TrimArc& piece) const
    {
        return std::min(beyond(piece.start()), beyond(piece.end())) < 0 &&
               std::max(beyond(piece.start()), beyond(piece.end())) <= 0;
    }
    // Not made of the pieces, which are cut where they turn, too.
    static LoopArc between(const LoopArc& whole, const TrimArc& first, const TrimArc& last)
    {
        LoopArc result = whole;
        TrimArc& arc = result.arc;
        if (last.to != arc.to) {
            arc = split(arc, (last.to - arc.from) / (arc.to - arc.from)).first;
            arc.to = last.to;
            arc.points.back().position = last.end();
        }
        if (first.from != arc.from) {
            arc = split(arc, (first.from - arc.from) / (arc.to - arc.from)).second;
            arc.from = first.from;
            arc.points.front().position = first.start();
        }
        return result;
    }

    void cut(const LoopChain& chain)
    {
        std::vector<LoopChain> runs(1);
        anyGoes_ = false;
        for (const LoopArc& part : chain)
            addParts(part, runs);
        if (!anyGoes_) {
            kept_.push_back(chain);
            return;
        }
        // The last one goes on at the chain's start.
        if (runs.size() > 1 && !runs.front().empty() && !runs.back().empty() &&
            runs.back().back().arc.end() == runs.front().front().arc.start() &&
            runs.back().back().arc.end()[half_.axis] != half_.at) {
            runs.back().insert(runs.back().end(), runs.front().begin(), runs.front().end());
            runs.front().clear();
        }
        for (LoopChain& run : runs)
            if (!run.empty()) {
                run.front().arc.points.front().position[half_.axis] = half_.at;
                run.back().arc.points.back().position[half_.axis] = half_.at;
                runs_.push_back(std::move(run));
            }
    }

    // Where a run meets the line.
    struct End {
        double place = 0;
        size_t run = 0;
        bool atStart = false;
    };

    // Between the first and the second end, the third and the fourth, and so on, the line borders what stays.
    void link()
    {
        std::vector<End> ends;
        for (size_t k = 0; k < runs_.size(); ++k) {
            ends.push_back({runs_[k].front().arc.start()[1 - half_.axis], k, true});
            ends.push_back({runs_[k].back().arc.end()[1 - half_.axis], k, false});
        }
        std::stable_sort(ends.begin(), ends.end(),
                         [](const End& a, const End& b) { return a.place < b.place; });
        std::vector<size_t> whereStart(runs_.size());
        std::vector<size_t> whereEnd(runs_.size());
        for (size_t k = 0; k < ends.size(); ++k)
            (ends[k].atStart ? whereStart : whereEnd)[ends[k].run] = k;
        std::vector<bool> isUsed(runs_.size(), false);
        const bool goesUp = (half_.axis == 0) == half_.below;
        for (size_t pair = 0; pair < ends.size(); pair += 2) {
            if (isUsed[ends[pair].run] || isUsed[ends[pair + 1].run])
                continue;
            // What is enclosed lies to the left.
            size_t at = goesUp ? pair : pair + 1;
            const size_t first = at;
            LoopChain chain;
            do {
                const size_t next = at ^ 1U;
                if (ends[at].place != ends[next].place)
                    chain.push_back(lineArc(onLine(ends[at].place), onLine(ends[next].place)));
                const End& end = ends[next];
                isUsed[end.run] = true;
                LoopChain run = end.atStart ? std::move(runs_[end.run]) : reversed(std::move(runs_[end.run]));
                chain.insert(chain.end(), run.begin(), run.end());
                at = end.atStart ? whereEnd[end.run] : whereStart[end.run];
            } while (at != first);
            straightenLines(chain);
            if (chain.size() > 1)
                kept_.push_back(std::move(chain));
        }
    }
    [[nodiscard]] Vec2 onLine(double place) const
    {
        return half_.axis == 0 ? Vec2(half_.at, place) : Vec2(place, half_.at);
    }

    HalfPlane half_;
    double nothing_;
    CuttingLines lines_;
    std::vector<LoopChain> kept_;
    std::vector<LoopChain> runs_;  // open, from the line to the line
    bool anyGoes_ = false;
};

// Between the bounds, where some chain reaches beyond one by more than `slack`.
void clip(std::vector<LoopChain>& chains, int axis, double low, double high, double nothing, double slack)
{
    double least = 1e300;
    double most = -1e300;
    for (const LoopChain& chain : chains)
        for (const LoopArc& part : chain)
            for (const TrimPoint& point : part.arc.points) {
                least = std::min(least, point.position[axis]);
                most = std::max(most, point.position[axis]);
            }
    if (least < low - slack)
        chains = clipped(chains, {axis, low, false}, nothing);
    if (most > high + slack)
        chains = clipped(chains, {axis, high, true}, nothing);
}

bool reaches(const std::vector<LoopChain>& chains, int axis, double low, double high)
{
    bool any = false;
    for (const LoopChain& chain : chains)
        for (const LoopArc& part : chain)
            for (const TrimPoint& point : part.arc.points)
                any = any || point.position[axis] < low || point.position[axis] > high;
    return any;
}

// A chain that is a loop as it stands in the file.
const TrimLoop* wholeLoop(const LoopChain& chain, const std::vector<TrimLoop>& loops)
{
    const auto first =
        std::find_if(chain.begin(), chain.end(), [](const LoopArc& part) { return part.curve != kNoCurve; });
    if (first == chain.end() || first->loop >= loops.size())
        return nullptr;
    const TrimLoop& loop = loops[first->loop];
    std::vector<TrimArc> arcs;
    for (const TrimCurve& curve : loop.curves)
        for (TrimArc& arc : bezierArcs(curve))
            arcs.push_back(std::move(arc));
    size_t next = 0;
    for (const LoopArc& part : chain) {
        if (part.curve == kNoCurve)
            continue;
        if (next == arcs.size() || part.loop != first->loop || part.arc.points != arcs[next].points)
            return nullptr;
        ++next;
    }
    return next == arcs.size() ? &loop : nullptr;
}

}  // namespace

Error cannotFollow(const LoopReading& reading)
{
    const auto open = std::find_if(reading.findings.begin(), reading.findings.end(),
                                   [](const auto& finding) { return finding.trouble == LoopTrouble::open; });
    const std::string number = open == reading.findings.end() ? "" : " " + std::to_string(open->loop + 1);
    return {"The trim loops cannot be followed: loop" + number + " is open", {}, "Untrim the surface first"};
}

std::vector<LoopChain> clipped(const std::vector<LoopChain>& chains, const HalfPlane& half, double nothing)
{
    Clipping clipping(half, nothing);
    for (const LoopChain& chain : chains)
        clipping.add(chain);
    return clipping.taken();
}

LoopChain borderChain(const NurbsSurface& surface, double beyond)
{
    const Vec2 by = beyond * (highOf(surface) - lowOf(surface));
    const Vec2 low = lowOf(surface) - by;
    const Vec2 high = highOf(surface) + by;
    const Vec2 right(high.x, low.y);
    const Vec2 left(low.x, high.y);
    return {lineArc(low, right), lineArc(right, high), lineArc(high, left), lineArc(left, low)};
}

DomainChains withinDomain(LoopReading reading, const NurbsSurface& surface, bool needsBorder)
{
    const Vec2 low = lowOf(surface);
    const Vec2 high = highOf(surface);
    const Vec2 size = high - low;
    DomainChains set{std::move(reading.chains), reading.startsInside};
    for (const int axis : {0, 1}) {
        const double slack = kRoundingBeyond * size[axis];
        needsBorder = needsBorder || reaches(set.chains, axis, low[axis] - slack, high[axis] + slack);
    }
    if (set.startsInside && needsBorder) {
        // From further out than any chain, so that it is cut off with them.
        set.chains.push_back(borderChain(surface, 16));
        set.startsInside = false;
    }
    for (const int axis : {0, 1})
        clip(set.chains, axis, low[axis], high[axis], kNothing * size[axis], kRoundingBeyond * size[axis]);
    return set;
}

std::vector<TrimLoop> loopsOf(const DomainChains& set, const std::vector<TrimLoop>& loops)
{
    std::vector<TrimLoop> result;
    for (const LoopChain& chain : set.chains) {
        if (const TrimLoop* whole = wholeLoop(chain, loops))
            result.push_back(*whole);
        else
            result.push_back(loopOf(chain, loops, signedArea(chain) > 0));
        if (set.startsInside)
            result.back().outer = false;
    }
    const bool anyOuter =
        std::any_of(result.begin(), result.end(), [](const auto& loop) { return loop.outer; });
    if (!set.startsInside && !anyOuter && !result.empty())
        result.front().outer = true;
    return result;
}

Result<std::optional<std::vector<TrimLoop>>> loopsBetween(const std::vector<TrimLoop>& loops,
                                                          const NurbsSurface& surface, int axis, double low,
                                                          double high)
{
    std::optional<std::vector<TrimLoop>> result{loops};
    if (loops.empty())
        return result;
    LoopReading reading = readLoops(loops, surface);
    if (reading.refused)
        return tl::unexpected(cannotFollow(reading));
    const double size = (highOf(surface) - lowOf(surface))[axis];
    const double nothing = kNothing * size;
    // Holes that the cut goes through need a border around them.
    bool isCut = false;
    for (const LoopChain& chain : reading.chains)
        for (const double line : {low, high})
            if (line > lowOf(surface)[axis] && line < highOf(surface)[axis])
                isCut = isCut || (reaches({chain}, axis, -1e300, line + nothing) &&
                                  reaches({chain}, axis, line - nothing, 1e300));
    DomainChains set = withinDomain(std::move(reading), surface, isCut);
    clip(set.chains, axis, low, high, nothing, nothing);
    if (set.chains.empty() && !set.startsInside) {
        result.reset();
        return result;
    }
    result = loopsOf(set, loops);
    return result;
}

}  // namespace knotspan
