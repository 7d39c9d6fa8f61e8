#include "model/trimming/loop_combining.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/trimming/arc_meetings.h"
#include "model/trimming/loop_chains.h"
#include "model/trimming/loop_clipping.h"
#include "model/trimming/loop_crossings.h"

namespace knotspan {

namespace {

constexpr double kAtEnd = 1e-9;  // of an arc: a cut nearer to its end is at the end

Vec2 lowOf(const NurbsSurface& surface)
{
    return {surface.knotsU().domainStart(), surface.knotsV().domainStart()};
}

Vec2 highOf(const NurbsSurface& surface)
{
    return {surface.knotsU().domainEnd(), surface.knotsV().domainEnd()};
}

// From one meeting to the next along a chain; a chain without meetings is one whole.
struct Run {
    LoopChain arcs;
    size_t from = 0;  // meetings
    size_t to = 0;
};

struct Cut {
    size_t arc = 0;
    double t = 0;
    size_t meeting = 0;
    Vec2 at;
};

// A part of an arc, and the meeting that it starts at.
struct Stretch {
    LoopArc part;
    std::optional<size_t> meeting;
    Vec2 at;
};

// The chain cut at the places, in order. One that is near an arc's end is at the next one's start.
std::vector<Stretch> stretchesOf(const LoopChain& chain, std::vector<Cut> cuts)
{
    for (Cut& cut : cuts)
        if (cut.t > 1 - kAtEnd)
            cut = {(cut.arc + 1) % chain.size(), 0, cut.meeting, cut.at};
    std::sort(cuts.begin(), cuts.end(),
              [](const Cut& x, const Cut& y) { return std::pair(x.arc, x.t) < std::pair(y.arc, y.t); });
    std::vector<Stretch> stretches;
    auto next = cuts.begin();
    for (size_t k = 0; k < chain.size(); ++k) {
        stretches.push_back({chain[k], {}, {}});
        double done = 0;
        for (; next != cuts.end() && next->arc == k; ++next) {
            if (next->t > kAtEnd) {
                auto [below, above] = split(stretches.back().part.arc, (next->t - done) / (1 - done));
                stretches.push_back(stretches.back());
                stretches[stretches.size() - 2].part.arc = std::move(below);
                stretches.back().part.arc = std::move(above);
                done = next->t;
            }
            stretches.back().meeting = next->meeting;
            stretches.back().at = next->at;
        }
    }
    return stretches;
}

std::vector<Run> runsOf(const LoopChain& chain, std::vector<Cut> cuts)
{
    std::vector<Stretch> stretches = stretchesOf(chain, std::move(cuts));
    for (size_t k = 0; k < stretches.size(); ++k)
        if (stretches[k].meeting) {
            stretches[k].part.arc.points.front().position = stretches[k].at;
            stretches[(k + stretches.size() - 1) % stretches.size()].part.arc.points.back().position =
                stretches[k].at;
        }
    std::rotate(stretches.begin(),
                std::find_if(stretches.begin(), stretches.end(), [](const auto& s) { return s.meeting; }),
                stretches.end());
    std::vector<Run> runs;
    for (Stretch& stretch : stretches) {
        if (stretch.meeting) {
            if (!runs.empty())
                runs.back().to = *stretch.meeting;
            runs.push_back({{}, *stretch.meeting, 0});
        }
        runs.back().arcs.push_back(std::move(stretch.part));
    }
    runs.back().to = runs.front().from;
    return runs;
}

// A place well inside a run.
Vec2 middleOf(const LoopChain& arcs)
{
    const auto longest = std::max_element(arcs.begin(), arcs.end(), [](const LoopArc& x, const LoopArc& y) {
        return glm::length(x.arc.end() - x.arc.start()) < glm::length(y.arc.end() - y.arc.start());
    });
    return placeOf(longest->arc.points, 0.5);
}

// The sets whose common part is sought, cut at where they meet.
class Combining {
public:
    Combining(const DomainChains& a, const std::vector<LoopChain>& b, bool keepsInside,
              const NurbsSurface& surface)
        : a_(a),
          b_(b),
          keepsInside_(keepsInside),
          insideA_(a.chains),
          insideB_(b),
          low_(lowOf(surface)),
          high_(highOf(surface))
    {
    }

    Result<DomainChains> run(const std::vector<Meeting>& meetings)
    {
        addRuns(a_.chains, meetings, true);
        addRuns(b_, meetings, false);
        if (!link(meetings.size()))
            return failure("The curve only touches a trim loop that is there already",
                           "Draw it clear of that loop, or across it");
        DomainChains result{std::move(whole_), a_.startsInside && !keepsInside_};
        orient(result);
        return result;
    }

    // Whether the place is to be left.
    [[nodiscard]] bool isKept(const Vec2& place) const
    {
        return isInA(place) && insideB_.contains(place) == keepsInside_;
    }

private:
    [[nodiscard]] bool isInA(const Vec2& place) const { return insideA_.contains(place) != a_.startsInside; }

    void addRuns(const std::vector<LoopChain>& chains, const std::vector<Meeting>& meetings, bool areOfA)
    {
        for (size_t k = 0; k < chains.size(); ++k) {
            std::vector<Cut> cuts;
            for (size_t m = 0; m < meetings.size(); ++m) {
                const ChainPlace& place = areOfA ? meetings[m].a : meetings[m].b;
                if (place.chain == k)
                    cuts.push_back({place.arc, place.t, m, meetings[m].at});
            }
            if (cuts.empty()) {
                if (stays(chains[k], areOfA))
                    whole_.push_back(chains[k]);
                continue;
            }
            for (Run& run : runsOf(chains[k], std::move(cuts)))
                if (stays(run.arcs, areOfA))
                    runs_.push_back(std::move(run));
        }
    }
    [[nodiscard]] bool stays(const LoopChain& arcs, bool isOfA) const
    {
        const Vec2 place = middleOf(arcs);
        if (isOfA)
            return insideB_.contains(place) == keepsInside_;
        return glm::clamp(place, low_, high_) == place && isInA(place);
    }

    // Runs that end where others begin, made into chains; false where one ends and no other begins.
    bool link(size_t meetings)
    {
        std::vector<std::vector<size_t>> at(meetings);
        for (size_t k = 0; k < runs_.size(); ++k) {
            at[runs_[k].from].push_back(k);
            at[runs_[k].to].push_back(k);
        }
        if (std::any_of(at.begin(), at.end(),
                        [](const auto& ends) { return ends.size() % 2 != 0 || ends.size() > 2; }))
            return false;
        std::vector<bool> isUsed(runs_.size(), false);
        for (size_t first = 0; first < runs_.size(); ++first) {
            if (isUsed[first])
                continue;
            LoopChain chain;
            size_t now = first;
            size_t meeting = runs_[first].from;
            do {
                isUsed[now] = true;
                const bool forward = runs_[now].from == meeting;
                const LoopChain arcs = forward ? runs_[now].arcs : reversed(runs_[now].arcs);
                chain.insert(chain.end(), arcs.begin(), arcs.end());
                meeting = forward ? runs_[now].to : runs_[now].from;
                const std::vector<size_t>& here = at[meeting];
                now = here[0] == now ? here[1] : here[0];
            } while (now != first && !isUsed[now]);
            if (now != first || meeting != runs_[first].from)
                return false;
            straightenLines(chain);
            whole_.push_back(std::move(chain));
        }
        return true;
    }

    // What lies in no other, or in two, is an outer one: anticlockwise.
    static void orient(DomainChains& set)
    {
        for (LoopChain& chain : set.chains) {
            std::vector<LoopChain> others;
            for (const LoopChain& other : set.chains)
                if (&other != &chain)
                    others.push_back(other);
            const bool isOuter = ChainParity(others).contains(middleOf(chain)) == set.startsInside;
            if ((signedArea(chain) > 0) != isOuter)
                chain = reversed(std::move(chain));
        }
    }

    const DomainChains& a_;
    const std::vector<LoopChain>& b_;
    bool keepsInside_;
    ChainParity insideA_;
    ChainParity insideB_;
    Vec2 low_;
    Vec2 high_;
    std::vector<Run> runs_;
    std::vector<LoopChain> whole_;
};

// Spread evenly, and on no line that models prefer.
Vec2 placeNumber(int k, const Vec2& low, const Vec2& size)
{
    return low + size * glm::fract(Vec2(0.5) +
                                   static_cast<double>(k) * Vec2(0.7548776662466927, 0.5698402909980532));
}

Result<LoopReading> readCurve(const std::vector<TrimCurve>& curve, std::uint32_t number,
                              const NurbsSurface& surface)
{
    const std::vector<TrimLoop> loop{{true, curve}};
    LoopReading reading = readLoops(loop, surface);
    const bool isOpen =
        curve.empty() || glm::length((curve.back().evaluate(curve.back().knots().domainEnd()) -
                                      curve.front().evaluate(curve.front().knots().domainStart())) /
                                     (highOf(surface) - lowOf(surface))) > 1e-2;
    if (reading.refused || isOpen)
        return failure("The curve does not close on the surface", "Draw it so that it ends where it began");
    if (!crossingsOf(TrimRegion(loop, surface)).empty())
        return failure("The curve crosses itself", "Draw one that does not");
    for (LoopChain& chain : reading.chains)
        for (LoopArc& part : chain)
            part.loop = number;
    return reading;
}

}  // namespace

Result<std::vector<TrimLoop>> trimmedBy(const std::vector<TrimCurve>& curve,
                                        const std::vector<TrimLoop>& loops, const NurbsSurface& surface,
                                        KeptSide side)
{
    const Vec2 low = lowOf(surface);
    const Vec2 size = highOf(surface) - low;
    LoopReading reading = readLoops(loops, surface);
    if (reading.refused)
        return tl::unexpected(cannotFollow(reading));
    reading.startsInside = loops.empty() || reading.startsInside;
    const auto b = readCurve(curve, static_cast<std::uint32_t>(loops.size()), surface);
    if (!b)
        return tl::unexpected(b.error());
    bool needsBorder = false;
    for (const LoopChain& chain : b->chains)
        for (const LoopArc& part : chain)
            for (const TrimPoint& point : part.arc.points)
                needsBorder = needsBorder || glm::clamp(point.position, low, low + size) != point.position;
    auto meetings = meetingsOf(reading.chains, b->chains, size);
    needsBorder = needsBorder || !meetings || !meetings->empty();
    const DomainChains a = withinDomain(std::move(reading), surface, needsBorder);
    meetings = meetingsOf(a.chains, b->chains, size);
    if (!meetings)
        return tl::unexpected(meetings.error());
    Combining combining(a, b->chains, side == KeptSide::inside, surface);
    const auto set = combining.run(*meetings);
    if (!set)
        return tl::unexpected(set.error());
    if (set->chains.empty())
        return failure("The curve leaves nothing of the surface",
                       "Keep its other side, or draw another curve");
    std::vector<TrimLoop> all = loops;
    all.push_back({true, curve});
    std::vector<TrimLoop> result = loopsOf(*set, all);
    std::stable_partition(result.begin(), result.end(), [](const TrimLoop& loop) { return loop.outer; });
    const TrimRegion before(loops, surface);
    const TrimRegion after(result, surface);
    bool isSame = true;
    for (int k = 0; k < 500; ++k) {
        const Vec2 at = placeNumber(k, low, size);
        if (after.contains(at.x, at.y) != combining.isKept(at))
            return failure("The curve meets trim loops in a way that cannot be resolved",
                           "Move it a little, or untrim the surface first");
        isSame = isSame && before.contains(at.x, at.y) == after.contains(at.x, at.y);
    }
    if (isSame && meetings->empty() && result.size() == loops.size())
        return failure("The curve leaves all of the surface as it is",
                       "Draw it over what is left of the surface");
    return result;
}

std::vector<TrimLoop> withoutHoles(const std::vector<TrimLoop>& loops, const NurbsSurface& surface)
{
    const LoopReading reading = readLoops(loops, surface);
    if (reading.refused || reading.startsInside)
        return reading.refused ? loops : std::vector<TrimLoop>();
    // Those around a surface are closed far beyond its end.
    const Vec2 far = highOf(surface) + 0.75 * (highOf(surface) - lowOf(surface));
    const auto isAround = [&](const LoopChain& chain) {
        return std::any_of(chain.begin(), chain.end(), [&](const LoopArc& part) {
            return part.curve == kNoCurve && (part.arc.start().x > far.x || part.arc.start().y > far.y);
        });
    };
    std::vector<bool> isHole(loops.size(), false);
    for (const LoopChain& chain : reading.chains)
        for (const LoopChain& other : reading.chains)
            if (other.front().loop != chain.front().loop && !isAround(chain) && !isAround(other) &&
                ChainParity({other}).contains(middleOf(chain)))
                isHole[chain.front().loop] = true;
    // In a band around a surface every other loop is one.
    const bool hasBand = std::any_of(reading.chains.begin(), reading.chains.end(), isAround);
    std::vector<TrimLoop> result;
    for (size_t k = 0; k < loops.size(); ++k)
        if (!isHole[k] && !(hasBand && !loops[k].outer))
            result.push_back(loops[k]);
    return result;
}

}  // namespace knotspan
