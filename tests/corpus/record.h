// What became of one file of a corpus: a line of a table that a later run can go on from.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "tests/corpus/corpora.h"
#include "tests/corpus/program_run.h"

namespace knotspan::corpus {

enum class Outcome : std::uint8_t {
    read,     // with a report
    refused,  // with exit code 1 and one line that says why
    crashed,
    hung,
    strange,  // anything else: another exit code, no line or several, an answer that is no JSON
};

[[nodiscard]] const char* nameOf(Outcome outcome);

struct Record {
    std::string corpus;
    std::string file;
    Outcome outcome = Outcome::strange;
    int leaked = 0;
    double seconds = 0;    // by the clock on the wall
    double computing = 0;  // seconds of it, however busy the machine is
    double peakMb = 0;
    std::uint64_t bytes = 0;
    // Of the faces that the file has.
    int faces = 0;
    int exact = 0;
    int approximated = 0;
    int refused = 0;
    int untrimmed = 0;
    double relativeError = 0;  // of the approximated ones, by the diagonal of the model's box
    std::uint64_t surfaces = 0;
    std::uint64_t triangles = 0;
    std::string sentence;                 // why it was refused, without the file's name
    std::map<std::string, int> refusals;  // of faces: how many for which reason
};

[[nodiscard]] Record recordOf(const ModelFile& file, const ProgramRun& run);

// A line of tab-separated values without its end, and back; nothing where it is none.
[[nodiscard]] std::string headerLine();
[[nodiscard]] std::string lineOf(const Record& record);
[[nodiscard]] std::optional<Record> recordFrom(const std::string& line);

}  // namespace knotspan::corpus
