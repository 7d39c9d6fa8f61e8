// Planes have no parameters of their own: here they get those in which their face is the smallest rectangle.
#pragma once

#include <optional>

#include <Geom_Plane.hxx>
#include <TopoDS_Face.hxx>

#include "model/cad/occt_surface.h"

namespace knotspan::occt {

struct AlignedPlane {
    Handle(Geom_Plane) plane;
    ParameterRange range;
};

// The face's plane turned so that u runs along the longest straight edge, and the rectangle around the face:
// the side of a box, however it lies in the file, becomes a rectangle without trim curves. Nothing where the
// face has no straight edge or an edge without a curve.
[[nodiscard]] std::optional<AlignedPlane> alignedPlane(const TopoDS_Face& face,
                                                       const Handle(Geom_Plane) & plane);

}  // namespace knotspan::occt
