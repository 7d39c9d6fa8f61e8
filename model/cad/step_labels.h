// The names and colours that a STEP file gives its faces, their bodies and products, found without the reader
// for them, which links a display.
#pragma once

#include <map>

#include <STEPControl_Reader.hxx>

#include "model/cad/occt_entities.h"
#include "model/cad/occt_reading.h"

namespace knotspan::formats {

class StepLabels {
public:
    // After the transfer.
    explicit StepLabels(const STEPControl_Reader& reader);

    [[nodiscard]] ShapeName name(const TopoDS_Shape& shape) const;
    // A face has its own colour or that of the nearest shell or solid around it.
    [[nodiscard]] std::optional<Colour> colour(const TopoDS_Face& face) const;

private:
    ShapeEntities entities_;
    std::map<const TopoDS_TShape*, Colour> colours_;  // of faces
};

}  // namespace knotspan::formats
