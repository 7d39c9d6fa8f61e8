// The process that reads a file for another: `knotspan import-worker FILE`.
#pragma once

#include <filesystem>

namespace knotspan::formats {

// Reads the file and tells what it found on standard output, in the lines of import_lines.h; what libraries
// print there is thrown away. Ends the process without tidying up: what a library left behind cannot crash it
// any more.
[[noreturn]] void runImportWorker(const std::filesystem::path& path);

}  // namespace knotspan::formats
