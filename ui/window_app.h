// The program with its window.
#pragma once

#include <filesystem>
#include <vector>

namespace knotspan {

// Opens the window, the first file in it, adds the others' objects, and runs until the window is closed.
// Without a file it shows the start page. Returns the exit code: 1, with a sentence on standard error, where
// there is no display.
int runWindow(int& argc, char** argv, const std::vector<std::filesystem::path>& files);

}  // namespace knotspan
