// Replacing a file so that, whatever happens, the old one or the new one is there, whole.
#pragma once

#include <filesystem>
#include <functional>

#include "model/core/result.h"

namespace knotspan::formats {

// Whether the file can be opened; refuses with the system's reason.
[[nodiscard]] Result<void> openedForReading(const std::filesystem::path& path);

// Lets `writeTo` write a temporary file beside `path`, brings it to the disk and renames it to `path`. On
// failure nothing is left behind, and what a killed process left is removed by the next that writes the same
// file. A link stays a link: what it points to is replaced. From any thread and any number of processes.
[[nodiscard]] Result<void>
replaceFile(const std::filesystem::path& path,
            const std::function<Result<void>(const std::filesystem::path&)>& writeTo);

// The same for a text that is there already.
[[nodiscard]] Result<void> replaceText(const std::filesystem::path& path, const std::string& text);

}  // namespace knotspan::formats
