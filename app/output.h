// What the commands write: files whole or not at all, messages in one line each.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "model/formats/format_list.h"

class QIODevice;

namespace knotspan::app {

// A file to write, by a function that returns false where the device refused something.
struct OutputFile {
    std::filesystem::path path;
    std::function<bool(QIODevice&)> write;
};

// Writes all of them or, where one fails, none: each goes to a temporary file beside it first.
[[nodiscard]] Result<void> writeFiles(const std::vector<OutputFile>& files);

// Whether writeFiles() could begin; for what takes long before there is something to write.
[[nodiscard]] Result<void> checkPlace(const std::filesystem::path& path);

// Standard error: "knotspan: SENTENCE".
void tell(const std::string& sentence);

// Tells the error; returns the exit code for it.
[[nodiscard]] int failed(const Error& error);

// formats::readWithNotes, with the notes told; of a file called `name` where that is not its path.
[[nodiscard]] Result<formats::Import> readImport(const std::filesystem::path& path, std::string name = {});
[[nodiscard]] Result<Scene> readModel(const std::filesystem::path& path);

}  // namespace knotspan::app
