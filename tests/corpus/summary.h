// The table of a run over the corpora: a row a corpus, and what was refused why.
#pragma once

#include <string>
#include <vector>

#include "tests/corpus/record.h"

namespace knotspan::corpus {

// In Markdown.
[[nodiscard]] std::string tableOf(const std::vector<Record>& records);
[[nodiscard]] std::string reasonsOf(const std::vector<Record>& records);

// Those that no file may show; a line each.
[[nodiscard]] std::string wrongsOf(const std::vector<Record>& records);

}  // namespace knotspan::corpus
