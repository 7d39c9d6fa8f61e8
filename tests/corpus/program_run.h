// The program on one file, from outside: what it says, how long it takes, what memory, what it leaves behind.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace knotspan::corpus {

struct ProgramRun {
    int status = 0;               // as waitpid() tells
    bool tookTooLong = false;     // and was killed
    int leaked = 0;               // processes of its that outlived it by two seconds
    double seconds = 0;           // by the clock on the wall
    double computing = 0;         // seconds, of all its processes
    std::uint64_t peakBytes = 0;  // resident, of the largest of its processes
    std::string output;
    std::string messages;
};

// Runs it without a display, files for its output in the scratch folder. From any thread.
[[nodiscard]] ProgramRun runOn(const std::vector<std::string>& command, double secondsAllowed,
                               const std::filesystem::path& scratch);

}  // namespace knotspan::corpus
