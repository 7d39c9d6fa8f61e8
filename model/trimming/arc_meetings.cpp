#include "model/trimming/arc_meetings.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace knotspan {

namespace {

constexpr double kAccuracy = 1e-12;  // of the domain
constexpr double kSame = 1e-9;       // of the domain: meetings nearer than that are one
constexpr int kMostOfTwo = 40;  // boxes that two arcs may share in the end, until they run along each other
constexpr double kMostSteps = 4000;

// A monotone part of an arc.
struct Part {
    ChainPlace place;
    TrimArc arc;
    double from = 0;  // of the whole arc's t
    double to = 1;
    Vec2 low;
    Vec2 high;
};

// By its ends, because it is monotone.
void measure(Part& part)
{
    part.low = glm::min(part.arc.start(), part.arc.end());
    part.high = glm::max(part.arc.start(), part.arc.end());
}

std::vector<Part> partsOf(const std::vector<LoopChain>& chains)
{
    const CuttingLines nowhere{{}, Vec2(0)};
    std::vector<Part> parts;
    for (size_t chain = 0; chain < chains.size(); ++chain)
        for (size_t k = 0; k < chains[chain].size(); ++k) {
            const TrimArc& whole = chains[chain][k].arc;
            for (TrimArc& arc : cutArcs(whole, nowhere)) {
                const double length = whole.to - whole.from;
                Part part{{chain, k, 0}, std::move(arc), 0, 1, {}, {}};
                part.from = (part.arc.from - whole.from) / length;
                part.to = (part.arc.to - whole.from) / length;
                measure(part);
                parts.push_back(std::move(part));
            }
        }
    return parts;
}

std::pair<Part, Part> halves(const Part& part)
{
    auto [below, above] = split(part.arc, 0.5);
    const double middle = (part.from + part.to) / 2;
    std::pair<Part, Part> result{{part.place, std::move(below), part.from, middle, {}, {}},
                                 {part.place, std::move(above), middle, part.to, {}, {}}};
    measure(result.first);
    measure(result.second);
    return result;
}

class Finding {
public:
    explicit Finding(const Vec2& size) : size_(size) {}

    bool add(const Part& a, const Part& b)
    {
        ofTwo_ = 0;
        steps_ = 0;
        return look(a, b);
    }
    [[nodiscard]] std::vector<Meeting> taken() { return std::move(found_); }

private:
    [[nodiscard]] bool isSmall(const Part& part) const
    {
        const Vec2 extent = (part.high - part.low) / size_;
        return std::max(extent.x, extent.y) <= kAccuracy;
    }
    // False where there are too many.
    bool look(const Part& a, const Part& b)
    {
        const Vec2 slack = 1e-14 * size_;
        if (a.low.x > b.high.x + slack.x || b.low.x > a.high.x + slack.x || a.low.y > b.high.y + slack.y ||
            b.low.y > a.high.y + slack.y)
            return true;
        if (++steps_ > kMostSteps)
            return false;
        if (isSmall(a) && isSmall(b))
            return add({at(a), at(b), 0.5 * (a.arc.start() + a.arc.end())});
        const Vec2 extentA = (a.high - a.low) / size_;
        const Vec2 extentB = (b.high - b.low) / size_;
        if (std::max(extentA.x, extentA.y) >= std::max(extentB.x, extentB.y)) {
            const auto [below, above] = halves(a);
            return look(below, b) && look(above, b);
        }
        const auto [below, above] = halves(b);
        return look(a, below) && look(a, above);
    }
    static ChainPlace at(const Part& part)
    {
        ChainPlace place = part.place;
        place.t = (part.from + part.to) / 2;
        return place;
    }
    bool add(const Meeting& meeting)
    {
        for (const Meeting& other : found_) {
            const Vec2 way = glm::abs(meeting.at - other.at) / size_;
            if (meeting.a.chain == other.a.chain && meeting.b.chain == other.b.chain &&
                std::max(way.x, way.y) <= kSame)
                return true;
        }
        found_.push_back(meeting);
        return ++ofTwo_ <= kMostOfTwo;
    }

    Vec2 size_;
    std::vector<Meeting> found_;
    int ofTwo_ = 0;
    int steps_ = 0;
};

}  // namespace

Result<std::vector<Meeting>> meetingsOf(const std::vector<LoopChain>& a, const std::vector<LoopChain>& b,
                                        const Vec2& size)
{
    Finding finding(size);
    const std::vector<Part> ofB = partsOf(b);
    for (const Part& part : partsOf(a))
        for (const Part& other : ofB)
            if (!finding.add(part, other))
                return failure("The curve runs along a trim loop that is there already",
                               "Draw it clear of that loop, or across it");
    return finding.taken();
}

}  // namespace knotspan
