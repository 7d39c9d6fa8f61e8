// The units of length that files name in words.
#pragma once

#include <string>

namespace knotspan::formats {

// Our short name ("mm", "in") for what STEP and IGES files call a unit ("MILLIMETRE", "INCH"); another name
// as it is.
[[nodiscard]] std::string unitCalled(const std::string& name);

// Millimetres in one of those units ("mm", "in"); 0 for a name we do not know.
[[nodiscard]] double millimetresIn(const std::string& unit);

// What the user should be told where lengths of that unit came out in millimetres; empty: nothing.
[[nodiscard]] std::string conversionToMillimetres(const std::string& unit);

}  // namespace knotspan::formats
