// How the hand moves the eye: pure functions from a way in pixels to a camera.
#pragma once

#include "renderer/scene/camera.h"

namespace knotspan {

// The picture that the hand works on, in pixels.
struct PictureSize {
    int width = 1;
    int height = 1;

    [[nodiscard]] double aspect() const { return double(width) / double(height); }
};

// The picture's height is half a turn. `way` goes right and down.
[[nodiscard]] Camera orbited(Camera camera, const Vec2& way, const PictureSize& size);

// What is at the target's depth stays under the cursor.
[[nodiscard]] Camera panned(Camera camera, const Vec2& way, const PictureSize& size);

// `steps` notches of a wheel closer (negative: away); what is under the cursor, at the target's depth, stays.
[[nodiscard]] Camera zoomed(Camera camera, double steps, const Vec2& cursor, const PictureSize& size);

// Looks at the point, which is then in the middle, and at `units` around it; from where it was, or, where the
// surface there would be seen from behind or from its edge, against `outward` (zero: nobody knows).
[[nodiscard]] Camera closeTo(Camera camera, const Vec3& point, double units, const Vec3& outward);

}  // namespace knotspan
