// What a file format can do. Each format is one file that fills this in, and one line in format_list.cpp.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/files/import_report.h"
#include "model/scene/scene.h"

namespace knotspan::formats {

// What reading a file gave: the model, and a sentence for each thing that could not be taken over as it was
// (a face that was left out, a surface that was approximated).
struct Import {
    Scene scene;
    std::vector<std::string> notes;
    ImportReport report;
};

struct Format {
    std::string name;                     // "STEP"
    std::vector<std::string> extensions;  // without the dot, lower case: {"step", "stp"}
    // Null where the format cannot be read or written. The errors need not name the file: read() and write()
    // do.
    Result<Import> (*read)(const std::filesystem::path&) = nullptr;
    Result<void> (*write)(const Scene&, const std::filesystem::path&) = nullptr;
    // For formats whose library may crash, hang or swallow the memory: read() with progress, to be called in
    // a process of its own (isolated_import.h). Null: read() is safe in this one.
    Result<Import> (*readIsolated)(const std::filesystem::path&, const ImportProgress&) = nullptr;
    bool namesUnits = true;    // or leaves open what its numbers are
    bool holdsMeshes = false;  // what write() writes
    // Holds all that a scene has, so that saving goes back to the file a model was opened from. From other
    // formats we understand a part: their files are not overwritten unasked.
    bool isOwn = false;
};

}  // namespace knotspan::formats
