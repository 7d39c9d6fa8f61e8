// From the texts of the command line to values. What cannot be one is a CLI::ValidationError, so exit code 2.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "model/core/space.h"

namespace knotspan::app {

// FILE, and --json: as in every command that reads a model and prints.
void addModel(CLI::App& command, std::string& file);
void addJson(CLI::App& command, bool& json);

// Finite, and nothing before or behind it; `option` is named in the error.
[[nodiscard]] double parseNumber(const std::string& option, const std::string& text);

// "a,,b" has three parts, "" has one.
[[nodiscard]] std::vector<std::string> splitAtCommas(const std::string& text);

// "1,-2.5,3e2": exactly `count` numbers.
[[nodiscard]] std::vector<double> parseNumbers(const std::string& option, const std::string& text,
                                               size_t count);
[[nodiscard]] Vec3 parseVec3(const std::string& option, const std::string& text);

struct PixelSize {
    int width = 1280;
    int height = 800;
};
// "1280x800", each 1 to 16384.
[[nodiscard]] PixelSize parseSize(const std::string& option, const std::string& text);

// Options that CLI11 turns into numbers itself: finite and from `low` to `high`.
[[nodiscard]] CLI::Validator within(double low, double high);
[[nodiscard]] CLI::Validator wholeWithin(int low, int high);

// Says that `text` is none of `names`.
[[noreturn]] void refuseName(const std::string& option, const std::string& text,
                             const std::vector<std::string>& names);

// A file to be written must have the extension of a format that can be.
void checkWritable(const std::string& option, const std::filesystem::path& path,
                   const std::string& also = {});

// A file to be written must end in `extension` (".png") and must not be the model that is read.
void checkOutput(const std::string& option, const std::string& path, const std::string& extension,
                 const std::string& model);

// Whether both name one file, by links too; no name names one.
[[nodiscard]] bool isSameFile(const std::string& a, const std::string& b);

[[nodiscard]] std::string joined(const std::vector<std::string>& texts, const std::string& separator);

}  // namespace knotspan::app
