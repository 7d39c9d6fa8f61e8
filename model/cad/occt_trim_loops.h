// From the wires of OpenCASCADE's faces to our trim loops.
#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "model/cad/occt_surface.h"
#include "model/geometry/trim_loop.h"

namespace knotspan::occt {

// The loops of the face in the (u, v) of `converted`, the outer one first, each closed and inside the domain,
// with the face on its left. None where the boundary is the surface's own four sides. Fails with a sentence
// where the boundary cannot be followed; may also throw Standard_Failure.
[[nodiscard]] Result<std::vector<TrimLoop>> trimLoops(const TopoDS_Face& face,
                                                      const ConvertedSurface& converted);

}  // namespace knotspan::occt
