// What of a net in homogeneous pixels the picture can show, and where: what the bounds of screen_error.h and
// grid_choice.h are made of.
#pragma once

#include "model/analysis/screen_error.h"

namespace knotspan {

// Where projected points lie: no further than `radius` from `middle`.
struct Disc {
    Vec2 middle{0, 0};
    double radius = 0;

    [[nodiscard]] static Disc around(const std::vector<Vec2>& points);
    [[nodiscard]] static Disc ofBox(const Vec2& low, const Vec2& high);

    // d.xy - s d.w with s in the middle, and the most it can differ for another s of the disc.
    [[nodiscard]] Vec2 seen(const Vec4& d) const { return Vec2(d) - middle * d.w; }
    [[nodiscard]] double doubt(const Vec4& d) const;
    [[nodiscard]] double largestSeen(const Vec4& d) const;
};

// Points inside the net's hull that the picture shows, be they of the surface or of triangles between its
// points.
struct NetOnScreen {
    NetOnScreen(const BezierNet& net, const ScreenView& view);

    bool visible = true;  // false: none shows
    bool inFront = true;  // no control point is behind the near plane
    Disc disc;            // of those that show
    double nearest = 0;   // their smallest w
    bool whole = false;   // the whole hull shows
    double farthest = 0;  // the largest w of the control points
};

// The control points of a second derivative over [0, 1] x [0, 1]: (2, 0), (1, 1) or (0, 2). Empty where the
// degree leaves none.
[[nodiscard]] std::vector<Vec4> secondDerivatives(const BezierNet& net, int orderU, int orderV);

}  // namespace knotspan
