// STEP (ISO 10303-21): read through OpenCASCADE, every face as one NURBS surface.
#pragma once

#include "model/files/format.h"

namespace knotspan::formats {

// Analytic and B-spline faces come exactly, offset surfaces to 1e-4 of their size; placements are applied to
// the coordinates, which come in millimetres. Faces that are no surfaces are left out and noted. One file is
// read at a time, whichever thread asks.
[[nodiscard]] Result<Import> readStep(const std::filesystem::path& path);

[[nodiscard]] Format stepFormat();

}  // namespace knotspan::formats
