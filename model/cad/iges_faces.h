// A face as a trimmed surface of IGES.
#pragma once

#include <BRepToIGES_BREntity.hxx>
#include <IGESData_IGESEntity.hxx>
#include <TopoDS_Face.hxx>

namespace knotspan::formats {

// What OpenCASCADE's own writer makes of a B-spline face that is no part of a shell, but in time that grows
// with the edges, where that one asks for the extent of the whole face at each. The edges must be in order.
// Null where the surface cannot be written.
[[nodiscard]] Handle(IGESData_IGESEntity) igesFace(const TopoDS_Face& face, const BRepToIGES_BREntity& maker);

}  // namespace knotspan::formats
