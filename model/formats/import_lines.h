// What the process that reads a file tells the one that asked for it: lines of a word and JSON.
//
//     progress {"stage": "Converting face 12 of 340", "done": 0.52}
//     object {...}           an object of a .knotspan file, to the last bit
//     mesh {...}             a mesh of one
//     end {...}              units, notes and report: the model is whole
//     error {"what": "...", "remedy": "..."}
//
// The sender may have been made to say anything by the file it reads: every line is checked as if it were
// one.
#pragma once

#include <optional>
#include <string_view>

#include "model/files/format.h"

namespace knotspan::formats {

// Each with its line end.
[[nodiscard]] std::string progressLine(const std::string& stage, double done);
[[nodiscard]] std::string objectLine(const SceneObject& object);
[[nodiscard]] std::string meshLine(const MeshObject& mesh);
[[nodiscard]] std::string endLine(const Import& import);
[[nodiscard]] std::string errorLine(const Error& error);

// Puts the lines together again.
class ImportLines {
public:
    explicit ImportLines(const ImportProgress& progress) : progress_(progress) {}

    // A line without its end. Refuses one that is none of the above; nothing more is to be taken then, nor
    // after the last line, whose result() is there.
    [[nodiscard]] Result<void> take(std::string_view line);

    // After `end`, the model; after `error`, that error.
    [[nodiscard]] bool isComplete() const { return result_.has_value(); }
    [[nodiscard]] Result<Import> result() && { return std::move(*result_); }

private:
    [[nodiscard]] Result<void> takeObject(std::string_view text);
    [[nodiscard]] Result<void> takeMesh(std::string_view text);
    [[nodiscard]] static Result<Scene> sceneOf(const char* list, std::string_view text);
    [[nodiscard]] Result<void> takeEnd(std::string_view text);

    const ImportProgress& progress_;
    Import import_;
    std::optional<Result<Import>> result_;
};

}  // namespace knotspan::formats
