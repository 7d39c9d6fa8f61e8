// BREP: OpenCASCADE's own text format, every face as one NURBS surface, as from STEP, and back.
#pragma once

#include "model/files/format.h"

namespace knotspan::formats {

// The format knows neither units nor names nor colours: numbers are taken as millimetres. One file is read at
// a time, whichever thread asks.
[[nodiscard]] Result<Import> readBrep(const std::filesystem::path& path);

// Coordinates go out in millimetres.
[[nodiscard]] Result<void> writeBrep(const Scene& scene, const std::filesystem::path& path);

[[nodiscard]] Format brepFormat();

}  // namespace knotspan::formats
