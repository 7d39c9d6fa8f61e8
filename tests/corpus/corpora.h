// Models that other people made, as Debian packages and a folder of ours bring them: thousands of files from
// many programs, whose readers are tested by running the program on each.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace knotspan::corpus {

struct ModelFile {
    std::string corpus;  // the package, or "models"
    std::string name;    // below the corpus's folder; inside of archives too: "part.fcstd/Shape.brp"
    std::filesystem::path path;
};

struct Corpus {
    std::string name;
    std::vector<ModelFile> files;  // none: it is not installed
};

// All corpora that we know, with the files of every format that can be read. Packed files (.gz, FreeCAD's
// archives) are unpacked into the scratch folder.
[[nodiscard]] std::vector<Corpus> corpora(const std::filesystem::path& scratch);

// An order that is the same each time and everywhere, and in which each part looks like the whole.
[[nodiscard]] std::vector<ModelFile> shuffled(std::vector<ModelFile> files);

// The N-th of M shares, for N of 1 .. M: several machines can divide a corpus.
[[nodiscard]] std::vector<ModelFile> shareOf(const std::vector<ModelFile>& files, size_t n, size_t m);

}  // namespace knotspan::corpus
