// A surface turned so that one of its edges lies at u = start and runs along v: what works on an edge then
// knows one case instead of four.
#pragma once

#include "model/geometry/bezier_conversion.h"

namespace knotspan {

// The edge keeps its parameter. Nothing is rounded: edgeBack(edgeFirst(s, side), side) is s, to the bit.
[[nodiscard]] NurbsSurface edgeFirst(const NurbsSurface& surface, Side side);
[[nodiscard]] NurbsSurface edgeBack(const NurbsSurface& surface, Side side);

// Clamped in both directions; itself where it is already.
[[nodiscard]] NurbsSurface clamped(const NurbsSurface& surface);

// With control points taken through an affine transform.
[[nodiscard]] NurbsSurface placed(const NurbsSurface& surface, const Mat4& transform);

// With other control points in the net's row u = `row`.
[[nodiscard]] NurbsSurface withRow(const NurbsSurface& surface, int row,
                                   const std::vector<ControlPoint>& points);

// The net's row u = `row`.
[[nodiscard]] std::vector<ControlPoint> rowOf(const NurbsSurface& surface, int row);

}  // namespace knotspan
