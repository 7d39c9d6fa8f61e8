// IGES: read through OpenCASCADE, every surface or face as one NURBS surface, as STEP is.
#pragma once

#include "model/files/format.h"

namespace knotspan::formats {

// B-spline surfaces come as they are: none is broken at its knots. Coordinates come in millimetres. One file
// is read at a time, whichever thread asks.
[[nodiscard]] Result<Import> readIges(const std::filesystem::path& path);

[[nodiscard]] Format igesFormat();

}  // namespace knotspan::formats
