#include "renderer/overlays/face_outlines.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "model/trimming/face_outline.h"

namespace knotspan {

namespace {

constexpr double kDeviation = 1.0 / 2000;  // of a KSQuad's side
constexpr int kMostHalvings = 8;

double distanceToLine(const Vec2& at, const Vec2& from, const Vec2& to)
{
    const Vec2 along = to - from;
    const double length = glm::length(along);
    const Vec2 way = at - from;
    return length > 0 ? std::abs(along.x * way.y - along.y * way.x) / length : glm::length(way);
}

class Chords {
public:
    Chords(int countV, std::vector<OutlineChord>& to) : countV_(countV), to_(to) {}

    void add(const RegionPiece& piece)
    {
        add(piece, 0, piece.points.front().position, 1, piece.points.back().position, 0);
    }

private:
    // Pieces are monotone, so that three places tell how they bend.
    void add(const RegionPiece& piece, double s, const Vec2& from, double end, const Vec2& to, int halvings)
    {
        const auto at = [&](double part) { return placeOf(piece.points, std::lerp(s, end, part)); };
        const Vec2 middle = at(0.5);
        const bool isBent = piece.points.size() > 2 && halvings < kMostHalvings &&
                            (distanceToLine(middle, from, to) > kDeviation ||
                             distanceToLine(at(0.25), from, to) > kDeviation ||
                             distanceToLine(at(0.75), from, to) > kDeviation);
        if (isBent) {
            add(piece, s, from, std::lerp(s, end, 0.5), middle, halvings + 1);
            add(piece, std::lerp(s, end, 0.5), middle, end, to, halvings + 1);
            return;
        }
        to_.push_back({static_cast<std::uint32_t>(piece.a * countV_ + piece.b), from, to});
    }

    int countV_;
    std::vector<OutlineChord>& to_;
};

bool hasSameBorder(const SceneObject& x, const SceneObject& y)
{
    return x.trimLoops == y.trimLoops && x.surface.knotsU() == y.surface.knotsU() &&
           x.surface.knotsV() == y.surface.knotsV();
}

}  // namespace

const std::vector<OutlineChord>& FaceOutlines::of(const Resident& resident)
{
    Held& held = held_[resident.id];
    const bool isSame =
        held.object && held.trim == resident.trim &&
        (held.object == resident.object || resident.trim || hasSameBorder(*held.object, *resident.object));
    held.trim = resident.trim;
    held.object = resident.object;
    if (isSame)
        return held.chords;
    held.chords.clear();
    const bool isTrimmedThere = isTrimmed(resident);
    const TrimRegion region(isTrimmedThere ? held.object->trimLoops : std::vector<TrimLoop>(),
                            held.object->surface);
    Chords chords(region.countV(), held.chords);
    for (const OutlineArc& arc : outlineOf(region))
        for (const RegionPiece& piece : arc.pieces)
            chords.add(piece);
    return held.chords;
}

}  // namespace knotspan
