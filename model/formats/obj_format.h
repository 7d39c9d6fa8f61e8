// OBJ (Wavefront): free-form surfaces, read and written, and polygons, read (docs/formats.md).
#pragma once

#include <ostream>
#include <string_view>

#include "model/files/format.h"

namespace knotspan::formats {

// The B-spline and Bezier surfaces of the text, each exactly, and its polygons as one mesh. Refuses, with the
// line, what cannot be understood; surfaces that are none and what is not read (curves in space) are noted.
[[nodiscard]] Result<Import> sceneFromObj(std::string_view text);

// What stands before the unit in the first line of our own files: OBJ itself has none.
constexpr std::string_view kObjUnits = " Coordinates are in ";

// Every object, hidden ones too, in model space. Refuses coordinates that are no longer finite there.
[[nodiscard]] Result<void> writeObj(const Scene& scene, std::ostream& out);

[[nodiscard]] Format objFormat();

}  // namespace knotspan::formats
