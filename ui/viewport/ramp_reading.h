// The number behind a colour of the picture: what a shading with a ramp shows at a place, from the surface
// itself.
#pragma once

#include <optional>

#include <QString>

#include "renderer/renderer.h"

namespace knotspan {

// Whether the shading's colours are numbers of the surface.
[[nodiscard]] bool showsNumbers(Shading shading);

// At a place that was picked in a picture of that frame. Nothing where the shading has no number there.
[[nodiscard]] std::optional<double> rampNumber(const Scene& scene, const Frame& frame,
                                               const PickedPlace& place);

// It with its name and unit.
[[nodiscard]] QString rampText(const Frame& frame, double number, const std::string& units);

}  // namespace knotspan
