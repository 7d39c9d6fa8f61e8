// Every way a model goes into a file, so that a new format is tested where the others are.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "model/core/result.h"

namespace knotspan::testing {

// Two models, told apart by any reader.
enum class Model { one, other };

struct Writer {
    std::string name;
    std::string extension;
    std::function<Result<void>(Model, const std::filesystem::path&)> write;
};

// NURBS formats, then those of meshes.
[[nodiscard]] std::vector<Writer> writers();

// Whether the file is that model, whole. `reference` was written by the same writer.
[[nodiscard]] bool isWhole(const std::filesystem::path& path, const std::filesystem::path& reference);

// How many files are in the folder, hidden ones too.
[[nodiscard]] size_t filesIn(const std::filesystem::path& folder);

}  // namespace knotspan::testing
