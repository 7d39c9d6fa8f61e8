#include "model/trimming/loop_chains.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "model/core/check.h"
#include "model/geometry/loop_direction.h"
#include "model/trimming/trim_region.h"

namespace knotspan {

namespace {

constexpr double kSameParameter = 1e-12;  // of the two that meet

bool isNear(double a, double b)
{
    return std::abs(a - b) <= kSameParameter * std::max({1.0, std::abs(a), std::abs(b)});
}

// Whether `next` goes on where `part` ends, on the same curve and in the same direction.
bool goesOn(const LoopArc& part, const LoopArc& next)
{
    const TrimArc& a = part.arc;
    const TrimArc& b = next.arc;
    return part.curve != kNoCurve && part.loop == next.loop && part.curve == next.curve &&
           a.points.size() == b.points.size() && (a.from < a.to) == (b.from < b.to) && isNear(a.to, b.from) &&
           a.end() == b.start() && isNear(a.points.back().weight, b.points.front().weight);
}

// Bézier arcs that follow each other, as one curve.
TrimCurve joined(std::span<const LoopArc> parts)
{
    const auto degree = static_cast<int>(parts[0].arc.points.size()) - 1;
    const double sign = parts[0].arc.from < parts[0].arc.to ? 1 : -1;
    std::vector<double> knots(static_cast<size_t>(degree) + 1, sign * parts[0].arc.from);
    std::vector<TrimPoint> points{parts[0].arc.points[0]};
    for (const LoopArc& part : parts) {
        points.insert(points.end(), part.arc.points.begin() + 1, part.arc.points.end());
        knots.insert(knots.end(), static_cast<size_t>(degree), sign * part.arc.to);
    }
    knots.push_back(knots.back());
    auto vector = KnotVector::create(degree, std::move(knots));
    check(vector.has_value(), "arcs of a curve have increasing parameters");
    auto curve = TrimCurve::create(*std::move(vector), std::move(points));
    check(curve.has_value(), "arcs of a curve make a curve");
    return *std::move(curve);
}

// The curve that the arcs are the whole of, unmoved.
const TrimCurve* wholeCurve(std::span<const LoopArc> parts, const std::vector<TrimLoop>& loops)
{
    const LoopArc& first = parts.front();
    if (first.curve == kNoCurve || first.loop >= loops.size() ||
        first.curve >= loops[first.loop].curves.size())
        return nullptr;
    const TrimCurve& curve = loops[first.loop].curves[first.curve];
    const std::vector<TrimArc> arcs = bezierArcs(curve);
    const bool isWhole =
        arcs.size() == parts.size() &&
        std::equal(arcs.begin(), arcs.end(), parts.begin(), [](const TrimArc& arc, const LoopArc& part) {
            return arc.from == part.arc.from && arc.to == part.arc.to && arc.points == part.arc.points;
        });
    return isWhole ? &curve : nullptr;
}

// The line that two lines on one line along u or v are together.
std::optional<LoopArc> together(const LoopArc& a, const LoopArc& b)
{
    if (a.curve != kNoCurve || b.curve != kNoCurve)
        return std::nullopt;
    for (const int axis : {0, 1})
        if (a.arc.start()[axis] == a.arc.end()[axis] && b.arc.start()[axis] == a.arc.end()[axis] &&
            b.arc.end()[axis] == a.arc.end()[axis])
            return lineArc(a.arc.start(), b.arc.end());
    return std::nullopt;
}

}  // namespace

LoopArc lineArc(const Vec2& from, const Vec2& to)
{
    return {TrimArc{{{from, 1}, {to, 1}}}, 0, kNoCurve};
}

LoopArc reversed(LoopArc part)
{
    std::reverse(part.arc.points.begin(), part.arc.points.end());
    std::swap(part.arc.from, part.arc.to);
    return part;
}

LoopChain reversed(LoopChain chain)
{
    std::reverse(chain.begin(), chain.end());
    for (LoopArc& part : chain)
        part = reversed(std::move(part));
    return chain;
}

double signedArea(const LoopChain& chain)
{
    constexpr int kSamples = 16;
    std::vector<Vec2> polygon;
    for (const LoopArc& part : chain)
        for (int k = 0; k < (part.arc.points.size() == 2 ? 1 : kSamples); ++k)
            polygon.push_back(placeOf(part.arc.points, static_cast<double>(k) / kSamples));
    return signedArea(polygon);
}

ChainParity::ChainParity(const std::vector<LoopChain>& chains)
{
    const CuttingLines nowhere{{}, Vec2(0)};
    for (const LoopChain& chain : chains)
        for (const LoopArc& part : chain)
            for (TrimArc& arc : cutArcs(part.arc, nowhere))
                arcs_.push_back(std::move(arc));
}

bool ChainParity::contains(const Vec2& place) const
{
    bool inside = false;
    for (const TrimArc& arc : arcs_) {
        const double start = arc.start().y;
        const double end = arc.end().y;
        if (place.y >= std::min(start, end) && place.y < std::max(start, end) &&
            runsLeftOf(arc.points, place))
            inside = !inside;
    }
    return inside;
}

TrimLoop loopOf(const LoopChain& chain, const std::vector<TrimLoop>& loops, bool outer)
{
    TrimLoop loop{outer, {}};
    // From where a curve begins, so that none is cut by where the chain happens to.
    size_t first = 0;
    while (first < chain.size() && goesOn(chain[(first + chain.size() - 1) % chain.size()], chain[first]))
        ++first;
    LoopChain parts = chain;
    std::rotate(parts.begin(), parts.begin() + static_cast<std::ptrdiff_t>(first % chain.size()),
                parts.end());
    for (size_t k = 0; k < parts.size();) {
        size_t next = k + 1;
        while (next < parts.size() && goesOn(parts[next - 1], parts[next]))
            ++next;
        const std::span<const LoopArc> run(parts.data() + k, next - k);
        const TrimCurve* whole = wholeCurve(run, loops);
        loop.curves.push_back(whole != nullptr ? *whole : joined(run));
        k = next;
    }
    return loop;
}

void straightenLines(LoopChain& chain)
{
    for (size_t k = 0; chain.size() > 1 && k < chain.size();) {
        const size_t next = (k + 1) % chain.size();
        const auto line = together(chain[k], chain[next]);
        if (!line) {
            ++k;
            continue;
        }
        chain[k] = *line;
        chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(next));
        if (line->arc.start() == line->arc.end())
            chain.erase(std::find_if(chain.begin(), chain.end(), [](const LoopArc& part) {
                return part.curve == kNoCurve && part.arc.start() == part.arc.end();
            }));
        k = 0;
    }
}

}  // namespace knotspan
