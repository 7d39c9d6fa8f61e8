// KSQuads of a scene as random views show them.
#pragma once

#include <random>
#include <vector>

#include "model/analysis/grid_choice.h"
#include "model/geometry/ksquad.h"
#include "model/scene/scene.h"

namespace knotspan::testing {

// A picture of 1920 x 1080 pixels of the box, from anywhere: from further away than it is large, from close
// by, from among its points (close: the near plane may then be far from the eye, and cut); with perspective
// or without. Nets are relative to `origin`.
struct RandomView {
    Mat4 toClip{1.0};
    ScreenView view;
};
[[nodiscard]] RandomView randomView(std::mt19937& random, const Box& box, const Vec3& origin, bool close,
                                    bool orthographic);

// The scene, or the surface, outlives it.
struct PlacedKsQuad {
    const NurbsSurface* surface;
    Mat4 transform;
    size_t number;  // of ksQuads()
};
[[nodiscard]] std::vector<PlacedKsQuad> ksQuadsOf(const Scene& scene);
[[nodiscard]] PlacedKsQuad randomKsQuad(std::mt19937& random, const NurbsSurface& surface);

// Its net in the view's pixels. The view takes points relative to the middle of the surface's bounds, so that
// digits are left far from the origin.
struct SeenKsQuad {
    const NurbsSurface* surface;
    size_t number;
    BezierNet net;
    ScreenView view;
};
[[nodiscard]] SeenKsQuad seenIn(const RandomView& random, const PlacedKsQuad& placed);

// From among the KSQuad's own control points, where the near plane cuts it.
[[nodiscard]] RandomView viewFromAmong(std::mt19937& random, const PlacedKsQuad& placed);

}  // namespace knotspan::testing
