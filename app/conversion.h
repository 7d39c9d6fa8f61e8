// One file turned into another format: what `knotspan convert` does once for each.
#pragma once

#include <optional>

#include "model/files/import_report.h"
#include "model/formats/mesh_export.h"

namespace knotspan::app {

struct ConvertOptions {
    double deviation = 0;  // 0: a thousandth of the model's diagonal
    std::optional<double> angleDegrees;
    bool verify = false;
};

struct Conversion {
    std::filesystem::path input;
    std::filesystem::path output;
    // What people are to be told where those are files that stand for standard streams; empty: the paths.
    std::string inputName;
    std::string outputName;
};

struct ConversionReport {
    std::string input;
    std::string output;
    std::optional<Error> error;
    std::vector<std::string> notes;  // what the user should know of either file
    double seconds = 0;
    double peakMebibytes = 0;
    std::optional<formats::ImportReport> import;    // of faces, where the file's format has some
    std::optional<formats::MeshExportReport> mesh;  // where a mesh was written
    std::optional<double> largestDifference;        // relative, where surfaces were verified
    bool isMeshVerified = false;

    // Whether a mesh was written that may be further from the surfaces than its deviation allows.
    [[nodiscard]] bool missesDeviation() const
    {
        return mesh && mesh->deviation && !mesh->deviation->isKept();
    }
};

// Whether it is a mesh that is written there: an .obj is one only where a deviation is asked for.
[[nodiscard]] std::optional<formats::MeshKind> meshKindOf(const std::filesystem::path& output,
                                                          const ConvertOptions& options);

// Tells on standard error what the user should know of both files. On failure the old file or none is there.
[[nodiscard]] ConversionReport convert(const Conversion& conversion, const ConvertOptions& options);

// One line of JSON; a sentence, or nothing where there is none to say.
[[nodiscard]] std::string jsonOf(const ConversionReport& report);
[[nodiscard]] std::string sentenceOf(const ConversionReport& report);

}  // namespace knotspan::app
