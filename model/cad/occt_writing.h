// What the writers of STEP, IGES and BREP share: OpenCASCADE quiet and one at a time, and its text brought to
// a file.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

#include "model/cad/occt_export.h"

namespace knotspan::formats {

// The scene's faces, handed to `write`, with nothing on standard output, whichever thread asks one after the
// other, and with OpenCASCADE's exceptions turned into errors.
[[nodiscard]] Result<void> writeFaces(const Scene& scene,
                                      const std::function<Result<void>(const occt::ExportedScene&)>& write);

// STEP and IGES take what is nearer together than a ten-millionth of a millimetre for one point. Refuses,
// with a sentence, a scene with an object no larger than some of those.
[[nodiscard]] Result<void> requireExtent(const occt::ExportedScene& scene, const std::string& format);

// Lets `print` write the whole file; fails with a sentence where the disk does not take it.
[[nodiscard]] Result<void> printTo(const std::filesystem::path& path,
                                   const std::function<void(std::ostream&)>& print);

// OpenCASCADE's name for our unit of length, millimetres for one that it does not have; `inch` is what it
// calls that in the format.
[[nodiscard]] std::string openCascadeUnit(const std::string& unit, const std::string& inch);

// How OpenCASCADE's writers print numbers so that the same double is read again. They have room for no more.
inline constexpr const char* kAllDigits = "%.16E";

}  // namespace knotspan::formats
