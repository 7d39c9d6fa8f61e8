// Bezier patches in the format of the teapot's data (.bpt): their number, and for each its two degrees and
// its control points.
#pragma once

#include <string_view>

#include "model/files/format.h"

namespace knotspan::formats {

// Each patch as one surface over 0 to 1; the points of a row along v follow one another. Refuses, with the
// line, what is none, and fewer or more patches than the file says.
[[nodiscard]] Result<Import> sceneFromBpt(std::string_view text);

[[nodiscard]] Format bptFormat();

}  // namespace knotspan::formats
