// Tiles drawn by the tessellation stages, whatever packing of the scene their KSQuads come from.
#pragma once

#include "renderer/paths/surface_path.h"

namespace knotspan {

[[nodiscard]] std::unique_ptr<SurfacePath> makeTessellatedTiles(const Device& device,
                                                                const Bindings& bindings,
                                                                const PathVariant& variant, Packing packing);

}  // namespace knotspan
