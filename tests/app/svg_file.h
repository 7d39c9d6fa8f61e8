// A drawing as a program that shows it would read it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace knotspan::testing {

struct SvgFile {
    size_t markers = 0;  // elements of class `marker`
    size_t curves = 0;   // of class `curve`
    std::string text;    // all of it, one text a line
};

// Nothing, and a failed expectation, where it is no well-formed XML.
[[nodiscard]] std::optional<SvgFile> readSvg(const std::filesystem::path& path);

}  // namespace knotspan::testing
