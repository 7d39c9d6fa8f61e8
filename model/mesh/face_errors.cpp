#include "model/mesh/face_errors.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace knotspan {

namespace {

constexpr double kRounding = 1 + 1e-9;

// The part of a piece between two of its parameters.
std::vector<TrimPoint> partOf(const RegionPiece& piece, double from, double to)
{
    TrimArc arc{piece.points};
    if (to < 1)
        arc = split(arc, to).first;
    if (from > 0)
        arc = split(arc, from / to).second;
    return arc.points;
}

// Of those in a part of an arc that may cross a knot line next to one of its ends.
const RegionPiece& longestPiece(const OutlineArc& arc, double from, double to)
{
    const auto first = static_cast<size_t>(from);
    const auto last = static_cast<size_t>(std::ceil(to)) - 1;
    const auto isWithOne = [](const RegionPiece& a, const RegionPiece& b) {
        return a.a == b.a && a.b == b.b;
    };
    if (isWithOne(arc.pieces[first], arc.pieces[last]))
        return arc.pieces[first];
    size_t longest = first;
    double most = -1;
    for (size_t k = first; k <= last; ++k) {
        const Vec2 size =
            arc.sizeBetween(std::max(from, static_cast<double>(k)), std::min(to, static_cast<double>(k + 1)));
        if (std::max(size.x, size.y) > most) {
            most = std::max(size.x, size.y);
            longest = k;
        }
    }
    return arc.pieces[longest];
}

}  // namespace

double FaceErrors::bound(int a, int b, const Vec2& size) const
{
    const double whole = shapes_.whole[number(a, b)].errorBound(size);
    return lengthInCells(a, b, size) <= kRounding ? std::min(whole, counts_.bounds[number(a, b)]) : whole;
}

bool FaceErrors::isFine(int a, int b, const Vec2& size) const
{
    if (lengthInCells(a, b, size) <= kRounding)
        return true;
    return !keepsCells_ && shapes_.whole[number(a, b)].errorBound(size) <= kForCells * deviation_;
}

double FaceErrors::spill(int a, int b, const OutlinePlace& place) const
{
    const Vec2 at = place.onLattice() - Vec2(a, b);
    const Vec2 off = glm::abs(at - glm::clamp(at, Vec2(0.0), Vec2(1.0)));
    const Vec2 speeds = glm::max(shapes_.speeds[number(a, b)], shapes_.speeds[number(place.a, place.b)]);
    return off.x * speeds.x + off.y * speeds.y;
}

double FaceErrors::chord(const OutlineArc& arc, double from, double to) const
{
    const RegionPiece& piece = longestPiece(arc, from, to);
    const double spills =
        spill(piece.a, piece.b, arc.placeAt(from)) + spill(piece.a, piece.b, arc.placeAt(to));
    return bound(piece.a, piece.b, arc.sizeBetween(from, to)) + 2 * spills;
}

double FaceErrors::sliver(const OutlineArc& arc, double from, double to) const
{
    const auto last = static_cast<size_t>(std::ceil(to));
    Vec2 speeds(0.0);
    for (auto k = static_cast<size_t>(from); k < last; ++k)
        speeds = glm::max(speeds, shapes_.speeds[number(arc.pieces[k].a, arc.pieces[k].b)]);
    const Vec2 base = arc.placeAt(from).onLattice();
    const Vec2 chord = arc.placeAt(to).onLattice() - base;
    double off = 0;
    const Vec2 scaled = chord * speeds;
    const double squared = glm::dot(scaled, scaled);
    for (auto k = static_cast<size_t>(from); k < last; ++k) {
        const RegionPiece& piece = arc.pieces[k];
        const double low = std::max(0.0, from - static_cast<double>(k));
        const double high = std::min(1.0, to - static_cast<double>(k));
        for (const TrimPoint& point : partOf(piece, low, high)) {
            const Vec2 way = Vec2(piece.a, piece.b) + point.position - base;
            const double share =
                squared > 0 ? std::clamp(glm::dot(way * speeds, scaled) / squared, 0.0, 1.0) : 0.0;
            const Vec2 away = glm::abs(way - share * chord);
            off = std::max(off, away.x * speeds.x + away.y * speeds.y);
        }
    }
    return off;
}

bool FaceErrors::isFine(const OutlineArc& arc, double from, double to) const
{
    constexpr double kOfCell = 0.75;
    constexpr double kOfError = 0.5;
    const RegionPiece& piece = longestPiece(arc, from, to);
    const Vec2 size = arc.sizeBetween(from, to);
    const double whole = shapes_.whole[number(piece.a, piece.b)].errorBound(Vec2(1));
    const bool flat = whole <= 0.2 * deviation_;
    const double left = flat ? 0.95 * deviation_ - whole : 0.25 * deviation_;
    if (lengthInCells(piece.a, piece.b, size) > kOfCell &&
        (keepsCells_ ||
         shapes_.whole[number(piece.a, piece.b)].errorBound(size) > kOfError * kForCells * deviation_))
        return false;
    return sliver(arc, from, to) <= left;
}

}  // namespace knotspan
