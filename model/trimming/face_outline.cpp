#include "model/trimming/face_outline.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

namespace {

// In the order of `Side`: on which side of the domain a piece lies whole, or -1.
int sideOf(const RegionPiece& piece, const TrimRegion& region)
{
    const auto all = [&](int axis, double at) {
        return std::all_of(piece.points.begin(), piece.points.end(),
                           [&](const TrimPoint& point) { return point.position[axis] == at; });
    };
    if (piece.a == 0 && all(0, 0))
        return 0;
    if (piece.a + 1 == region.countU() && all(0, 1))
        return 1;
    if (piece.b == 0 && all(1, 0))
        return 2;
    return piece.b + 1 == region.countV() && all(1, 1) ? 3 : -1;
}

Vec2 onLattice(const RegionPiece& piece, const TrimPoint& point)
{
    return Vec2(piece.a, piece.b) + point.position;
}

bool follows(const RegionPiece& before, const RegionPiece& after)
{
    return before.loop == after.loop && before.curve == after.curve &&
           onLattice(before, before.points.back()) == onLattice(after, after.points.front());
}

// Whether the outline turns sharply between two pieces.
bool turns(const RegionPiece& before, const RegionPiece& after)
{
    constexpr double kSharp = 0.05;  // radians; below, a chord may run past it
    if (before.a != after.a || before.b != after.b)
        return false;
    const auto way = [](const auto& first, const auto& last) {
        const Vec2 from = first->position;
        for (auto point = first + 1; point != last; ++point)
            if (point->position != from)
                return glm::normalize(point->position - from);
        return Vec2(0);
    };
    const Vec2 in = -way(before.points.rbegin(), before.points.rend());
    const Vec2 out = way(after.points.begin(), after.points.end());
    return glm::dot(in, out) < std::cos(kSharp);
}

// Stretches of one KSQuad's side that are covered an odd number of times.
class Stretches {
public:
    void add(double from, double to)
    {
        ++ends_[std::min(from, to)];
        --ends_[std::max(from, to)];
    }
    [[nodiscard]] std::vector<std::array<double, 2>> odd() const
    {
        std::vector<std::array<double, 2>> result;
        int covered = 0;
        double since = 0;
        for (const auto& [at, change] : ends_) {
            if (covered % 2 != 0 && at > since) {
                if (!result.empty() && result.back()[1] == since)
                    result.back()[1] = at;
                else
                    result.push_back({since, at});
            }
            covered += change;
            since = at;
        }
        return result;
    }

private:
    std::map<double, int> ends_;
};

class BorderOutline {
public:
    explicit BorderOutline(const TrimRegion& region)
        : counts_{region.countV(), region.countV(), region.countU(), region.countU()}
    {
        for (size_t side = 0; side < 4; ++side)
            stretches_[side].resize(static_cast<size_t>(counts_[side]));
    }

    void addAll()
    {
        for (auto& side : stretches_)
            for (Stretches& stretches : side)
                stretches.add(0, 1);
    }
    void add(int side, const RegionPiece& piece)
    {
        const int axis = side < 2 ? 1 : 0;
        const auto quad = static_cast<size_t>(axis == 1 ? piece.b : piece.a);
        stretches_[static_cast<size_t>(side)][quad].add(piece.points.front().position[axis],
                                                        piece.points.back().position[axis]);
    }
    void takeInto(std::vector<OutlineArc>& arcs) const
    {
        for (int side = 0; side < 4; ++side) {
            OutlineArc arc;
            const auto end = [&] {
                if (!arc.pieces.empty())
                    arcs.push_back(std::move(arc));
                arc = {};
            };
            for (int quad = 0; quad < counts_[static_cast<size_t>(side)]; ++quad)
                for (const auto& [from, to] :
                     stretches_[static_cast<size_t>(side)][static_cast<size_t>(quad)].odd()) {
                    const RegionPiece piece = lineOn(side, quad, from, to);
                    if (!arc.pieces.empty() && !follows(arc.pieces.back(), piece))
                        end();
                    arc.pieces.push_back(piece);
                }
            end();
        }
    }

private:
    [[nodiscard]] RegionPiece lineOn(int side, int quad, double from, double to) const
    {
        RegionPiece piece{0, kNoCurve, from, to, 0, 0, {}};
        const double across = side % 2;
        const bool alongV = side < 2;
        (alongV ? piece.b : piece.a) = quad;
        (alongV ? piece.a : piece.b) = side % 2 == 0 ? 0 : counts_[alongV ? 2 : 0] - 1;
        for (const double at : {from, to})
            piece.points.push_back({alongV ? Vec2(across, at) : Vec2(at, across), 1});
        return piece;
    }

    std::array<int, 4> counts_;
    std::array<std::vector<Stretches>, 4> stretches_;
};

}  // namespace

OutlinePlace OutlineArc::placeAt(double t) const
{
    const double last = end() - 1;
    const double number = std::clamp(std::floor(t), 0.0, last);
    const RegionPiece& piece = pieces[static_cast<size_t>(number)];
    const double s = t - number;
    if (s <= 0)
        return {piece.a, piece.b, piece.points.front().position};
    if (s >= 1)
        return {piece.a, piece.b, piece.points.back().position};
    return {piece.a, piece.b, knotspan::placeOf(piece.points, s)};
}

Vec2 OutlineArc::sizeBetween(double from, double to) const
{
    return glm::abs(placeAt(to).onLattice() - placeAt(from).onLattice());
}

std::vector<OutlineArc> outlineOf(const TrimRegion& region)
{
    std::vector<OutlineArc> arcs;
    BorderOutline border(region);
    if (!region.isTrimmed() || region.startsInside())
        border.addAll();
    if (region.isTrimmed())
        for (const std::vector<RegionPiece>& chain : region.chains()) {
            const RegionPiece* last = nullptr;
            for (const RegionPiece& piece : chain) {
                if (const int side = sideOf(piece, region); side >= 0) {
                    border.add(side, piece);
                    last = nullptr;
                    continue;
                }
                if (last == nullptr || !follows(*last, piece) || turns(*last, piece))
                    arcs.push_back({{}, piece.curve == kNoCurve});
                arcs.back().pieces.push_back(piece);
                last = &piece;
            }
        }
    border.takeInto(arcs);
    return arcs;
}

}  // namespace knotspan
