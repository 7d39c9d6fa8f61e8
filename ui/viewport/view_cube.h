// The cube in a view's upper right corner, which turns with the view: a click on a face, an edge or a corner
// looks from there, a drag turns the view.
#pragma once

#include "renderer/frame.h"

namespace knotspan {

struct CubePicture {
    const Camera& camera;
    int width = 0;  // of the view, pixels
    int height = 0;
    double pixelRatio = 1;
};

// From where a click looks: -1, 0 or 1 along each axis, not all 0. One number for a face, two for an edge,
// three for a corner.
using CubePart = Vec3;

// What of the cube is under a pixel of the view. Nothing where the view is too small to have one.
[[nodiscard]] std::optional<CubePart> cubePartAt(const Vec2& pixel, const CubePicture& picture);

// Adds the cube, with `hovered` lit.
void addViewCube(Overlays& overlays, const CubePicture& picture, const std::optional<CubePart>& hovered);

// The same target and distance, seen from that part.
[[nodiscard]] Camera lookedFrom(const CubePart& part, Camera camera);

}  // namespace knotspan
