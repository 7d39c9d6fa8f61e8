#include "model/trimming/loop_crossings.h"

#include <algorithm>
#include <map>
#include <set>

#include <glm/common.hpp>

namespace knotspan {

namespace {

constexpr double kApart = 1e-9;  // of a KSQuad: less is touching
constexpr int kMostPairs = 1000000;

struct Span {
    const RegionPiece* piece;
    Vec2 low;
    Vec2 high;

    explicit Span(const RegionPiece& of)
        : piece(&of),
          low(glm::min(of.points.front().position, of.points.back().position)),
          high(glm::max(of.points.front().position, of.points.back().position))
    {
    }
    [[nodiscard]] bool isLevel() const { return high.y - low.y < kApart; }
};

double uAt(const RegionPiece& piece, double v)
{
    const bool rises = piece.points.front().position.y <= piece.points.back().position.y;
    double below = rises ? 0 : 1;
    double above = 1 - below;
    for (int step = 0; step < 50; ++step) {
        const double t = (below + above) / 2;
        (placeOf(piece.points, t).y <= v ? below : above) = t;
    }
    return placeOf(piece.points, below).x;
}

// On which side of y the piece x runs at a height; 0: too near to tell.
int sideAt(const Span& x, const Span& y, double v)
{
    const double apart = uAt(*x.piece, v) - uAt(*y.piece, v);
    return apart > kApart ? 1 : apart < -kApart ? -1 : 0;
}

bool cross(const Span& x, const Span& y)
{
    if (x.low.x > y.high.x || y.low.x > x.high.x)
        return false;
    if (x.isLevel() && y.isLevel())
        return false;
    if (x.isLevel() || y.isLevel()) {
        const Span& level = x.isLevel() ? x : y;
        const Span& other = x.isLevel() ? y : x;
        const double v = level.low.y;
        const double u = uAt(*other.piece, v);
        return v > other.low.y + kApart && v < other.high.y - kApart && u > level.low.x + kApart &&
               u < level.high.x - kApart;
    }
    const double bottom = std::max(x.low.y, y.low.y);
    const double top = std::min(x.high.y, y.high.y);
    return top - bottom > kApart && sideAt(x, y, bottom) * sideAt(x, y, top) < 0;
}

using LoopPairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

void addCrossings(std::vector<Span>& spans, LoopPairs& found, int& pairs)
{
    std::sort(spans.begin(), spans.end(), [](const Span& x, const Span& y) { return x.low.y < y.low.y; });
    std::vector<const Span*> running;
    for (const Span& span : spans) {
        std::erase_if(running, [&](const Span* other) { return other->high.y < span.low.y; });
        for (const Span* other : running) {
            const auto loops = std::minmax(span.piece->loop, other->piece->loop);
            if (++pairs > kMostPairs)
                return;
            if (!found.contains(loops) && cross(span, *other))
                found.insert(loops);
        }
        running.push_back(&span);
    }
}

}  // namespace

std::vector<std::string> crossingsOf(const TrimRegion& region)
{
    std::map<std::pair<int, int>, std::vector<Span>> byKsquad;
    for (const auto& chain : region.chains())
        for (const RegionPiece& piece : chain)
            if (piece.curve != kNoCurve)
                byKsquad[{piece.a, piece.b}].emplace_back(piece);
    LoopPairs found;
    int pairs = 0;
    for (auto& [ksquad, spans] : byKsquad)
        addCrossings(spans, found, pairs);
    std::vector<std::string> sentences;
    for (const auto& [x, y] : found)
        sentences.push_back(x == y ? "Trim loop " + std::to_string(x + 1) + " crosses itself."
                                   : "Trim loops " + std::to_string(x + 1) + " and " + std::to_string(y + 1) +
                                         " cross each other.");
    return sentences;
}

}  // namespace knotspan
