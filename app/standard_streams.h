// Standard input and output as files, for what reads and writes files: `-` on the command line.
#pragma once

#include <filesystem>

#include "model/core/result.h"

namespace knotspan::app {

// A folder for such files, gone with this object.
class StreamFolder {
public:
    StreamFolder();
    ~StreamFolder();
    StreamFolder(const StreamFolder&) = delete;
    StreamFolder& operator=(const StreamFolder&) = delete;

    // All of standard input, as a file with that extension.
    [[nodiscard]] Result<std::filesystem::path> input(const std::string& extension) const;
    // Where to write what output() is to send.
    [[nodiscard]] Result<std::filesystem::path> place(const std::string& extension) const;

private:
    std::filesystem::path path_;  // empty: it could not be made
};

[[nodiscard]] Result<void> sendToOutput(const std::filesystem::path& file);

}  // namespace knotspan::app
