// The formats Knotspan knows, and the two functions through which all models come in and go out.
#pragma once

#include "model/files/format.h"
#include "model/formats/isolated_import.h"

namespace knotspan::formats {

[[nodiscard]] const std::vector<Format>& all();

// The format whose extension the path has, upper or lower case; null where none has it.
[[nodiscard]] const Format* find(const std::filesystem::path& path);

// Reads a model. Every failure (no file, a folder, unreadable, empty, too large, unknown extension, content
// that is no model) is an Error that names the file; nothing crashes or hangs on bad content.
[[nodiscard]] Result<Scene> read(const std::filesystem::path& path);

// The same, with what the user should be told about it: which faces were left out or approximated. `watch`
// follows and stops a reading in another process, as isReadApart() tells; the others are quick.
[[nodiscard]] Result<Import> readWithNotes(const std::filesystem::path& path, const ImportWatch& watch = {});

// Whether the file is read in a process of its own (isolated_import.h), and so may take long.
[[nodiscard]] bool isReadApart(const std::filesystem::path& path);

// Writes a model to a temporary file beside `path` and renames it, so that the old file or the new one is
// there, whole, whatever happens.
[[nodiscard]] Result<void> write(const Scene& scene, const std::filesystem::path& path);

}  // namespace knotspan::formats
