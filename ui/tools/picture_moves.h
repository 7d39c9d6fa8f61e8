// What a way of the hand on the picture means in the model: a movement, an angle, a factor.
#pragma once

#include "model/core/result.h"
#include "renderer/scene/camera.h"

namespace knotspan {

// How the model is seen. Ways and places are in pixels of the picture, y down.
struct PictureView {
    Camera camera;
    int width = 0;
    int height = 0;
    double pixelRatio = 1;  // pixels of the picture in one of the hand's

    [[nodiscard]] bool operator==(const PictureView&) const = default;
};

// In the plane through `start` that faces the eye, so that the place stays under the hand.
[[nodiscard]] Vec3 movedInViewPlane(const PictureView& view, const Vec3& start, const Vec2& way);

// How far along `axis` (unit) from `start` to the place that is nearest on the picture to where the hand is.
// Refuses, with a sentence, an axis that points at the eye, and ways beyond where it ends in the distance.
[[nodiscard]] Result<double> movedAlong(const PictureView& view, const Vec3& start, const Vec3& axis,
                                        const Vec2& way);

// How a circle around an axis is seen: where the first two of the three right-handed directions (first,
// second, axis) fall, for a circle of radius 1. Far from the middle of a perspective picture a circle is seen
// a little otherwise; drawn and turned by the same two it stays under the hand.
struct RingSeen {
    RingSeen(const Camera& camera, const Vec3& axis);

    [[nodiscard]] Vec2 at(double radians) const;         // on the circle
    [[nodiscard]] double depthAt(double radians) const;  // below 0: on the half that faces the eye
    // Where it is seen as hardly more than a line.
    [[nodiscard]] bool isEdgeOn() const;

    Vec2 first{0};
    Vec2 second{0};
    double firstDepth = 0;
    double secondDepth = 0;
};

// Degrees by the right hand about `axis`. The hand took hold at `from`, seen from the ring's middle. Of the
// angles that differ by whole turns the one nearest to `last`.
[[nodiscard]] double turnedBy(const PictureView& view, const Vec3& axis, const Vec2& from, const Vec2& way,
                              double radiusPx, double last);

}  // namespace knotspan
