// Files to be wary of: whole ones of every format that can be read, and what malice makes of them.
#pragma once

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "model/files/format.h"

namespace knotspan::testing {

struct HostileFile {
    std::string name;
    std::string extension;  // without the dot
    std::string content;
};

// Whole files of the format, small, as its writer or we write them; none is a test's failure: a new format
// whose files cannot be written here needs one.
[[nodiscard]] std::vector<HostileFile> wholeFilesOf(const formats::Format& format,
                                                    const std::filesystem::path& scratch);

// One of them, as a text; empty where none is written by hand.
[[nodiscard]] std::string handWrittenFile(const std::string& extension);

// What no reader must take for a model: claims of a million points without data, nesting as deep as the file
// is long, references to themselves.
[[nodiscard]] std::vector<HostileFile> impossibleFilesOf(const std::string& extension);

// The file with its references turned back on themselves, where it has any: read or refused.
[[nodiscard]] std::vector<HostileFile> cyclicFilesOf(const HostileFile& whole);

// Cut off at every 1/parts of its length; nothing at all is the first.
[[nodiscard]] std::vector<HostileFile> cutOff(const HostileFile& whole, size_t parts);
[[nodiscard]] std::vector<HostileFile> withOneByteChanged(const HostileFile& whole, int count);
[[nodiscard]] std::vector<HostileFile> ofRandomBytes(const std::string& extension, int count);

}  // namespace knotspan::testing
