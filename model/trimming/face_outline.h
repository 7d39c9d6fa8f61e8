// The outline of what is left of a surface: arcs of its trim curves, and the stretches of the domain's border
// that bound it.
//
// Along the border nothing of the loops' own curves is kept: what counts is which stretches bound the face,
// and those are the ones that loops cover an odd number of times.
#pragma once

#include "model/trimming/trim_region.h"

namespace knotspan {

// A place on a surface, by KSQuad.
struct OutlinePlace {
    int a = 0;
    int b = 0;
    Vec2 t{};

    // KSQuads before it and the place in it, along both axes.
    [[nodiscard]] Vec2 onLattice() const { return Vec2(a, b) + t; }
};

// Of one source, without sharp corners: a trim curve, a line that closes a gap, or a side of the domain. Its
// parameter runs over [0, pieces], piece k having [k, k + 1].
struct OutlineArc {
    std::vector<RegionPiece> pieces;  // each starts where the one before ends
    bool isBridge = false;            // a line between curves that do not meet

    [[nodiscard]] double end() const { return static_cast<double>(pieces.size()); }
    [[nodiscard]] OutlinePlace placeAt(double t) const;
    // Of the stretch between two parameters that crosses no knot line: its box, in its KSQuad.
    [[nodiscard]] Vec2 sizeBetween(double from, double to) const;
};

// A place is inside where a way to it from beyond the domain crosses arcs an odd number of times.
[[nodiscard]] std::vector<OutlineArc> outlineOf(const TrimRegion& region);

}  // namespace knotspan
