// Whether the meshes of the corpora's closed shells are closed, and within the deviation.
#pragma once

#include "tests/corpus/corpora.h"

namespace knotspan::corpus {

struct SolidMeshes {
    std::string corpus;
    size_t files = 0;   // STEP, IGES and BREP
    size_t unread = 0;  // of them, that OpenCASCADE could not read, or not in time
    size_t shells = 0;  // different closed ones, by OpenCASCADE
    size_t closed = 0;  // of them, whose mesh has no boundary edge
    size_t manifold = 0;
    size_t within = 0;       // no point measured beyond the deviation, a thousandth of the shell's size
    size_t beyondBound = 0;  // measured more than what was proved
    std::vector<std::string> unlike;  // a sentence for each that is not closed, or not within it
};

// Several files at once (jobs()); those of other formats are left out.
[[nodiscard]] SolidMeshes solidMeshesOf(const std::vector<ModelFile>& files,
                                        const std::filesystem::path& scratch);

[[nodiscard]] std::string tableOf(const std::vector<SolidMeshes>& corpora);

}  // namespace knotspan::corpus
