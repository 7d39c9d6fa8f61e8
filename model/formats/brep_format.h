// BREP: OpenCASCADE's own text format, every face as one NURBS surface, as from STEP.
#pragma once

#include "model/formats/format.h"

namespace knotspan::formats {

// The format knows neither units nor names nor colours: numbers are taken as millimetres. One file is read at
// a time, whichever thread asks.
[[nodiscard]] Result<Import> readBrep(const std::filesystem::path& path);

[[nodiscard]] Format brepFormat();

}  // namespace knotspan::formats
