// The names and colours that a STEP file gives its faces, found without the reader for them, which links a
// display.
#pragma once

#include <map>

#include <STEPControl_Reader.hxx>

#include "model/formats/occt_reading.h"

namespace knotspan::formats {

class StepLabels {
public:
    // After the transfer; the reader outlives it.
    explicit StepLabels(const STEPControl_Reader& reader);

    // A face has its own colour or that of the nearest shell or solid around it.
    [[nodiscard]] FaceLabel of(const TopoDS_Face& face) const;

private:
    const STEPControl_Reader& reader_;
    std::map<const TopoDS_TShape*, Colour> colours_;  // of faces
};

}  // namespace knotspan::formats
