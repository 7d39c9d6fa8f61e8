#include "renderer/overlays/trim_lines.h"

namespace knotspan {

namespace {

constexpr double kDeviation = 1.0 / 500;  // of a KSQuad's side

bool hasSameCurves(const SceneObject& x, const SceneObject& y)
{
    return x.trimLoops == y.trimLoops && x.surface.knotsU() == y.surface.knotsU() &&
           x.surface.knotsV() == y.surface.knotsV();
}

}  // namespace

const std::vector<TrimPiece>* TrimLines::of(ObjectId id, const SharedObject& object, const TrimPlace& place)
{
    if (place.loop >= object->trimLoops.size() || place.curve >= object->trimLoops[place.loop].curves.size())
        return nullptr;
    Held& held = held_[{id, place.loop, place.curve}];
    const bool same = held.object && (held.object == object || hasSameCurves(*held.object, *object));
    held.object = object;
    if (!same)
        held.pieces = trimPieces(object->trimLoops[place.loop].curves[place.curve], object->surface.knotsU(),
                                 object->surface.knotsV(), {kDeviation, 1, [](int, int) { return Vec2(1); }});
    return &held.pieces;
}

}  // namespace knotspan
