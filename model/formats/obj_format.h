// OBJ (Wavefront): free-form surfaces, read and written (docs/formats.md).
#pragma once

#include <ostream>
#include <string_view>

#include "model/formats/format.h"

namespace knotspan::formats {

// The B-spline and Bezier surfaces of the text, each exactly. Refuses, with the line, what cannot be
// understood; surfaces that are none and what is not read (meshes, curves in space) are noted.
[[nodiscard]] Result<Import> sceneFromObj(std::string_view text);

// Every object, hidden ones too, in model space. Refuses coordinates that are no longer finite there.
[[nodiscard]] Result<void> writeObj(const Scene& scene, std::ostream& out);

[[nodiscard]] Format objFormat();

}  // namespace knotspan::formats
