// From our trim loops to the wires of OpenCASCADE's faces.
#pragma once

#include <vector>

#include <TopoDS_Face.hxx>

#include "model/geometry/trim_loop.h"

namespace knotspan::occt {

// Adds the loops to a face that has a surface and no wires yet. The curves in (u, v) are kept number by
// number; those in space, which go with them, follow them within 1e-8 of `size`, the face's. What is one
// curve in space (the two sides of a seam) is one edge, what is one point there (a pole) a degenerated one.
// Fails with a sentence; may also throw Standard_Failure.
[[nodiscard]] Result<void> addWires(TopoDS_Face& face, const std::vector<TrimLoop>& loops, double size);

}  // namespace knotspan::occt
