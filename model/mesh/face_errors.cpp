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

double FaceErrors::sliver(const OutlineArc& arc, double from, double to) const
{
    const RegionPiece& first = arc.pieces[static_cast<size_t>(from)];
    const Vec2& speeds = shapes_.speeds[number(first.a, first.b)];
    const Vec2 base = arc.placeAt(from).t;
    const Vec2 chord = arc.placeAt(to).onLattice() - arc.placeAt(from).onLattice();
    const auto last = static_cast<size_t>(std::ceil(to));
    double off = 0;
    const Vec2 scaled = chord * speeds;
    const double squared = glm::dot(scaled, scaled);
    for (auto k = static_cast<size_t>(from); k < last; ++k) {
        const RegionPiece& piece = arc.pieces[k];
        const double low = std::max(0.0, from - static_cast<double>(k));
        const double high = std::min(1.0, to - static_cast<double>(k));
        for (const TrimPoint& point : partOf(piece, low, high)) {
            const Vec2 way = point.position - base;
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
    const RegionPiece& piece = arc.pieces[static_cast<size_t>((from + to) / 2)];
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
