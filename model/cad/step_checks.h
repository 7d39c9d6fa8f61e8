// What is checked of a STEP file before OpenCASCADE makes shapes of it, because it takes a file that ends too
// early for a smaller model and crashes on records that are not there.
#pragma once

#include <filesystem>

#include <STEPControl_Reader.hxx>

#include "model/core/result.h"

namespace knotspan::formats {

// The file as such: that it is one, its size, its first and its last line.
[[nodiscard]] Result<void> checkStepFrame(const std::filesystem::path& path);

// The records of the geometry, once they are read: that each could be, and that what OpenCASCADE takes for
// granted is there.
[[nodiscard]] Result<void> checkStepRecords(const STEPControl_Reader& reader);

}  // namespace knotspan::formats
