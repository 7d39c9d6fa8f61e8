// What a file format can do. Each format is one file that fills this in, and one line in format_list.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace knotspan::formats {

// What reading a file gave: the model, and a sentence for each thing that could not be taken over as it was (a
// face that was left out, a surface that was approximated).
struct Import {
    Scene scene;
    std::vector<std::string> notes;
};

struct Format {
    std::string name;                     // "STEP"
    std::vector<std::string> extensions;  // without the dot, lower case: {"step", "stp"}
    // Null where the format cannot be read or written. The errors need not name the file: read() and write()
    // do.
    Result<Import> (*read)(const std::filesystem::path&) = nullptr;
    Result<void> (*write)(const Scene&, const std::filesystem::path&) = nullptr;
};

}  // namespace knotspan::formats
