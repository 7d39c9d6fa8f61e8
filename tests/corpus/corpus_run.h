// Runs the program over files of the corpora, several at once, and keeps what became of each.
#pragma once

#include <filesystem>
#include <vector>

#include "tests/corpus/corpora.h"
#include "tests/corpus/record.h"

namespace knotspan::corpus {

// How many at once: KNOTSPAN_CORPUS_JOBS, or as many as there are processors.
[[nodiscard]] int jobs();

// Every line goes to the table as soon as it is known; files that stand there already are not read again.
// What stands there of these files in the end.
[[nodiscard]] std::vector<Record> runOver(const std::vector<ModelFile>& files,
                                          const std::filesystem::path& scratch,
                                          const std::filesystem::path& table);

}  // namespace knotspan::corpus
