// Which records of a file became which shape: OpenCASCADE answers that by looking through all of them each
// time.
#pragma once

#include <unordered_map>
#include <vector>

#include <TopoDS_Shape.hxx>
#include <XSControl_WorkSession.hxx>

namespace knotspan::formats {

class ShapeEntities {
public:
    // After the transfer.
    explicit ShapeEntities(const Handle(XSControl_WorkSession) & session);

    // Wherever the shape stands; in the order of the transfer: what is made of others comes after them.
    [[nodiscard]] const std::vector<Handle(Standard_Transient)>& of(const TopoDS_Shape& shape) const;

private:
    std::unordered_map<const TopoDS_TShape*, std::vector<Handle(Standard_Transient)>> entities_;
};

}  // namespace knotspan::formats
