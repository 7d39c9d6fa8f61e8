// Trim loops for formats whose faces lie within their surface and whose loops close.
#pragma once

#include "model/scene/scene.h"

namespace knotspan::formats {

// The scene with its loops as they are shown: cut off where they leave their surface's domain, none where
// they cannot be followed. Where the cut loops would not leave the same, or nothing is left at all, they stay
// as they are.
[[nodiscard]] Scene withLoopsAsShown(const Scene& scene);

}  // namespace knotspan::formats
