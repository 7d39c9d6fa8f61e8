// The view as trimming asks for it: whatever falls onto a surface along it.
#pragma once

#include "model/trimming/seen_borders.h"
#include "renderer/scene/camera.h"
#include "ui/tools/tool.h"

namespace knotspan {

// The plane's places are pixels of the picture, as Camera::toPixel.
[[nodiscard]] Sight sightOf(const Camera& camera, int width, int height);

// How far a projected curve may be off: the friends' gap, but no more and no less than shares of the
// surface's size.
[[nodiscard]] double trimTolerance(const ToolSettings& settings, const SceneObject& object);

// "exactly" or "to within 0.0012 mm": how near a projected curve is. What rounding leaves counts as exact.
[[nodiscard]] QString nearnessText(double error, const SceneObject& object, const std::string& units);

}  // namespace knotspan
