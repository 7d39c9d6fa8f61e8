#include "model/trimming/loop_reading.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "model/trimming/loop_chains.h"
#include "model/trimming/loop_nesting.h"

namespace knotspan {

namespace {

constexpr double kWidestGap = 5e-3;     // of the domain
constexpr double kSilentGap = 1e-6;     // below, a gap is rounding, and not spoken of
constexpr double kSilentBeyond = 1e-6;  // the same of what reaches out of the domain
constexpr double kMostPeriods = 3;
constexpr double kNothing = 1e-12;  // of the domain's area

// Of the curves themselves: control points may stand out far beyond.
struct Extent {
    Vec2 low{1e300};
    Vec2 high{-1e300};

    void add(const LoopChain& chain)
    {
        for (const LoopArc& part : chain)
            add(part.arc, kHalvings);
    }

private:
    static constexpr int kHalvings = 14;  // what is left is off by 4^-14 of the arc's size

    void add(const Vec2& place)
    {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }

    [[nodiscard]] bool holds(const TrimArc& arc) const
    {
        return std::all_of(arc.points.begin(), arc.points.end(), [&](const TrimPoint& point) {
            return glm::all(glm::lessThanEqual(low, point.position)) &&
                   glm::all(glm::lessThanEqual(point.position, high));
        });
    }

    void add(const TrimArc& arc, int halvings)
    {
        add(arc.start());
        add(arc.end());
        if (holds(arc))
            return;
        if (halvings == 0) {
            for (const TrimPoint& point : arc.points)
                add(point.position);
            return;
        }
        const auto [below, above] = split(arc, 0.5);
        add(below, halvings - 1);
        add(above, halvings - 1);
    }
};

class Reading {
public:
    explicit Reading(const NurbsSurface& surface)
        : surface_(surface),
          low_(surface.knotsU().domainStart(), surface.knotsV().domainStart()),
          size_(Vec2(surface.knotsU().domainEnd(), surface.knotsV().domainEnd()) - low_)
    {
    }

    void add(const TrimLoop& loop, std::uint32_t number)
    {
        loop_ = number;
        LoopChain chain = arcsOf(loop, number);
        if (chain.empty())
            return say(LoopTrouble::empty);
        bridgeGaps(chain);
        if (!close(chain, number))
            return;
        if (!wraps_) {
            const double area = signedArea(chain) / (size_.x * size_.y);
            if (std::abs(area) >= kNothing) {
                if ((area > 0) != loop.outer)
                    say(LoopTrouble::wrongWay);
            } else if (evenOddArea(chain) / (size_.x * size_.y) < kNothing) {
                say(LoopTrouble::enclosesNothing);
            }
            nesting_.add(chain, number, loop.outer);
        }
        place(std::move(chain));
    }

    LoopReading taken(const std::vector<TrimLoop>& loops)
    {
        const bool anyOuter = std::any_of(loops.begin(), loops.end(), [](const auto& l) { return l.outer; });
        reading_.startsInside = lowestWrap_ ? lowestWrap_->second : !anyOuter;
        if (reading_.refused)
            reading_.chains.clear();
        else if (!lowestWrap_ && !crossesSeam_)  // else a period decides what lies in what
            for (const LoopFinding& finding : nesting_.findings())
                reading_.findings.push_back(finding);
        return std::move(reading_);
    }

private:
    void say(LoopTrouble trouble, double share = 0) { reading_.findings.push_back({loop_, trouble, share}); }

    static LoopChain arcsOf(const TrimLoop& loop, std::uint32_t number)
    {
        LoopChain chain;
        for (size_t k = 0; k < loop.curves.size(); ++k)
            for (TrimArc& arc : bezierArcs(loop.curves[k]))
                chain.push_back({std::move(arc), number, static_cast<std::uint32_t>(k)});
        return chain;
    }

    static LoopArc line(const Vec2& from, const Vec2& to, std::uint32_t loop)
    {
        return {TrimArc{{{from, 1}, {to, 1}}}, loop, kNoCurve};
    }
    [[nodiscard]] double shareOf(const Vec2& way) const { return glm::length(way / size_); }

    // Between curves; not yet from the last one's end to the first one's start.
    void bridgeGaps(LoopChain& chain)
    {
        LoopChain whole;
        double widest = 0;
        for (LoopArc& part : chain) {
            if (!whole.empty() && whole.back().arc.end() != part.arc.start()) {
                widest = std::max(widest, shareOf(part.arc.start() - whole.back().arc.end()));
                whole.push_back(line(whole.back().arc.end(), part.arc.start(), part.loop));
            }
            whole.push_back(std::move(part));
        }
        chain = std::move(whole);
        widest_ = widest;
    }

    bool close(LoopChain& chain, std::uint32_t number)
    {
        wraps_ = false;
        const Vec2 start = chain.front().arc.start();
        const Vec2 end = chain.back().arc.end();
        for (const int axis : {0, 1}) {
            Vec2 period(0.0);
            period[axis] = end[axis] > start[axis] ? size_[axis] : -size_[axis];
            if (shareOf(end - start - period) <= kWidestGap && closedAlong(axis) && widest_ <= kWidestGap) {
                wrap(chain, axis, number);
                return true;
            }
        }
        widest_ = std::max(widest_, shareOf(start - end));
        if (widest_ > kWidestGap) {
            say(LoopTrouble::open, widest_);
            reading_.refused = true;
            return false;
        }
        if (widest_ > kSilentGap)
            say(LoopTrouble::gaps, widest_);
        if (start != end)
            chain.push_back(line(end, start, number));
        return true;
    }

    [[nodiscard]] bool closedAlong(int axis) const
    {
        return axis == 0 ? surface_.isClosedU() : surface_.isClosedV();
    }

    // A chain around the surface: closed beyond the domain's end across it. All are, so that they say
    // together what lies between them.
    void wrap(LoopChain& chain, int axis, std::uint32_t number)
    {
        wraps_ = true;
        const Vec2 start = chain.front().arc.start();
        const Vec2 end = chain.back().arc.end();
        const bool runsUp = end[axis] > start[axis];
        const bool insideBelow = runsUp == (axis == 1);
        const double at = start[1 - axis];
        if (!lowestWrap_ || at < lowestWrap_->first)
            lowestWrap_ = {at, insideBelow};
        Vec2 farEnd = end;
        Vec2 farStart = start;
        farEnd[1 - axis] = farStart[1 - axis] = low_[1 - axis] + 2 * size_[1 - axis];
        for (const auto& [from, to] : {std::pair(end, farEnd), {farEnd, farStart}, {farStart, start}})
            chain.push_back(line(from, to, number));
    }

    // Where it lies, and on a closed surface a period away.
    void place(LoopChain chain)
    {
        Extent extent;
        extent.add(chain);
        Vec2 first(0.0);
        Vec2 last(0.0);
        for (const int axis : {0, 1}) {
            const double below = (low_[axis] - extent.low[axis]) / size_[axis];
            const double above = (extent.high[axis] - low_[axis]) / size_[axis] - 1;
            if (std::max(below, above) <= kSilentBeyond || (wraps_ && above >= 1 - kSilentBeyond))
                continue;
            if (!closedAlong(axis)) {
                say(LoopTrouble::beyond, std::max(below, above));
                continue;
            }
            say(LoopTrouble::acrossSeam);
            crossesSeam_ = true;
            first[axis] = -std::min(kMostPeriods, std::ceil(std::max(0.0, above)));
            last[axis] = std::min(kMostPeriods, std::ceil(std::max(0.0, below)));
        }
        for (double i = first.x; i <= last.x; ++i)
            for (double j = first.y; j <= last.y; ++j) {
                LoopChain moved = chain;
                for (LoopArc& part : moved)
                    for (TrimPoint& point : part.arc.points)
                        point.position += Vec2(i, j) * size_;
                reading_.chains.push_back(std::move(moved));
            }
    }

    const NurbsSurface& surface_;
    Vec2 low_;
    Vec2 size_;
    LoopReading reading_;
    std::uint32_t loop_ = 0;
    double widest_ = 0;
    bool wraps_ = false;
    bool crossesSeam_ = false;
    LoopNesting nesting_;
    std::optional<std::pair<double, bool>> lowestWrap_;  // where, and whether the face lies below
};

}  // namespace

std::string spoken(double share)
{
    constexpr double kUncounted = 99;
    if (!(share < kUncounted))
        return "far more than the surface's size";
    if (share >= 0.995 && share < 1.05)
        return "about the surface's size";
    char text[64];
    std::snprintf(text, sizeof text, share < 1 ? "%.2g %% of the surface" : "%.2g times the surface's size",
                  share < 1 ? 100 * share : share);
    return text;
}

std::string sentenceOf(const LoopFinding& finding)
{
    const auto what = [&]() -> std::string {
        switch (finding.trouble) {
        case LoopTrouble::empty:
            return "has no curves and is left out";
        case LoopTrouble::open:
            return "is open by " + spoken(finding.share) + "; the surface is shown whole";
        case LoopTrouble::gaps:
            return "had gaps of up to " + spoken(finding.share) + ", closed by lines";
        case LoopTrouble::enclosesNothing:
            return "encloses nothing";
        case LoopTrouble::wrongWay:
            return "runs the wrong way round, which does not matter for what it encloses";
        case LoopTrouble::beyond:
            return "reaches beyond the surface by " + spoken(finding.share) + " and is cut off there";
        case LoopTrouble::acrossSeam:
            return "crosses the seam and goes on at its other side";
        case LoopTrouble::twice:
            return "is there twice; the two cancel each other, and neither is shown";
        case LoopTrouble::holeAround:
            return "is a hole around an outline; shown is what lies between them";
        case LoopTrouble::holeOutside:
            return "is a hole outside of all outlines; what it encloses is shown";
        }
        return {};
    };
    return "Trim loop " + std::to_string(finding.loop + 1) + " " + what() + ".";
}

LoopReading readLoops(const std::vector<TrimLoop>& loops, const NurbsSurface& surface)
{
    Reading reading(surface);
    for (size_t k = 0; k < loops.size(); ++k)
        reading.add(loops[k], static_cast<std::uint32_t>(k));
    return reading.taken(loops);
}

}  // namespace knotspan
