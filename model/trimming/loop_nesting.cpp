#include "model/trimming/loop_nesting.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/trimming/loop_chains.h"

namespace knotspan {
namespace {

constexpr double kSame = 1e-9;  // of the loop's size

std::vector<Vec2> polygonOf(const LoopChain& chain)
{
    constexpr int kSamples = 16;
    std::vector<Vec2> polygon;
    for (const LoopArc& part : chain) {
        const int samples = part.arc.points.size() == 2 ? 1 : kSamples;
        for (int k = 0; k < samples; ++k)
            polygon.push_back(placeOf(part.arc.points, static_cast<double>(k) / samples));
    }
    return polygon;
}

}  // namespace

void LoopNesting::add(const LoopChain& chain, std::uint32_t loop, bool outer)
{
    const std::vector<Vec2> polygon = polygonOf(chain);
    Member member{chain, loop, outer, 0, polygon[0], polygon[0], {}};
    double doubled = 0;
    Vec2 moment(0.0);
    for (size_t k = 0; k < polygon.size(); ++k) {
        member.low = glm::min(member.low, polygon[k]);
        member.high = glm::max(member.high, polygon[k]);
        const Vec2 a = polygon[k] - polygon[0];
        const Vec2 b = polygon[(k + 1) % polygon.size()] - polygon[0];
        const double part = a.x * b.y - a.y * b.x;
        doubled += part;
        moment += part * (a + b) / 3.0;
    }
    member.area = std::abs(doubled) / 2;
    member.middle = polygon[0] + (doubled != 0 ? moment / doubled : Vec2(0.0));
    members_.push_back(std::move(member));
}

// The same box, area and centre of it; where they start and which way they run is all the same.
bool LoopNesting::areOne(const Member& a, const Member& b)
{
    const double size = glm::length(a.high - a.low);
    const auto isNear = [&](const Vec2& one, const Vec2& other) {
        return glm::distance(one, other) <= kSame * size;
    };
    return a.area > 0 && isNear(a.low, b.low) && isNear(a.high, b.high) &&
           std::abs(a.area - b.area) <= kSame * a.area && glm::distance(a.middle, b.middle) <= 1e-6 * size;
}

std::vector<LoopFinding> LoopNesting::findings() const
{
    std::vector<LoopFinding> found;
    std::set<std::uint32_t> twice;
    std::vector<const Member*> bySize;
    for (const Member& member : members_)
        bySize.push_back(&member);
    std::stable_sort(bySize.begin(), bySize.end(),
                     [](const Member* a, const Member* b) { return a->area < b->area; });
    for (size_t k = 0; k < bySize.size(); ++k)
        for (size_t next = k + 1; next < bySize.size() && bySize[next]->area <= (1 + kSame) * bySize[k]->area;
             ++next)
            if (areOne(*bySize[k], *bySize[next])) {
                found.push_back({bySize[next]->loop, LoopTrouble::twice});
                twice.insert({bySize[k]->loop, bySize[next]->loop});
            }
    std::vector<LoopChain> outlines;
    for (const Member& member : members_)
        if (member.outer)
            outlines.push_back(member.chain);
    if (outlines.empty())
        return found;
    const ChainParity inOutlines(outlines);
    for (const Member& hole : members_) {
        if (hole.outer || twice.contains(hole.loop))
            continue;
        const std::vector<Vec2> places = polygonOf(hole.chain);
        if (std::any_of(places.begin(), places.end(),
                        [&](const Vec2& place) { return inOutlines.contains(place); }))
            continue;
        const ChainParity inHole({hole.chain});
        const bool isAround = std::any_of(outlines.begin(), outlines.end(), [&](const LoopChain& outline) {
            return inHole.contains(outline.front().arc.start());
        });
        found.push_back({hole.loop, isAround ? LoopTrouble::holeAround : LoopTrouble::holeOutside});
    }
    return found;
}

double evenOddArea(const LoopChain& chain)
{
    constexpr int kLines = 64;
    const std::vector<Vec2> polygon = polygonOf(chain);
    double low = polygon[0].y;
    double high = low;
    for (const Vec2& place : polygon) {
        low = std::min(low, place.y);
        high = std::max(high, place.y);
    }
    double area = 0;
    for (int line = 0; line < kLines; ++line) {
        const double v = low + (high - low) * (line + 0.4871) / kLines;  // through no corner of a drawing
        std::vector<double> crossings;
        for (size_t k = 0; k < polygon.size(); ++k) {
            const Vec2& a = polygon[k];
            const Vec2& b = polygon[(k + 1) % polygon.size()];
            if ((a.y <= v) != (b.y <= v))
                crossings.push_back(a.x + (b.x - a.x) * ((v - a.y) / (b.y - a.y)));
        }
        std::sort(crossings.begin(), crossings.end());
        for (size_t k = 1; k < crossings.size(); k += 2)
            area += (crossings[k] - crossings[k - 1]) * (high - low) / kLines;
    }
    return area;
}

}  // namespace knotspan
