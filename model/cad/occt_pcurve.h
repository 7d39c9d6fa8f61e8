// One edge's curve in the parameter plane of a face, from OpenCASCADE's parameters to ours.
#pragma once

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "model/cad/occt_surface.h"
#include "model/geometry/trim_loop.h"

namespace knotspan::occt {

// In the direction of the edge's orientation. Exact where the maps only shift and for lines along u or v;
// elsewhere (a slanting curve on a cylinder, say) within 1e-8 of the domain's size.
[[nodiscard]] Result<TrimCurve> toTrimCurve(const TopoDS_Edge& edge, const TopoDS_Face& face,
                                            const ConvertedSurface& converted);

}  // namespace knotspan::occt
