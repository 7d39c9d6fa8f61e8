// The program run again and again as processes of its own, several at a time, so that what ends one of them
// (a crash, a limit) does not end the others.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace knotspan::app {

struct ChildRun {
    int status = 0;  // as waitpid() tells
    std::string output;
    std::string messages;  // standard error
    double seconds = 0;
    double peakMebibytes = 0;

    [[nodiscard]] int exitCode() const;     // -1: ended by a signal
    [[nodiscard]] bool isDone() const;      // exit code 0
    [[nodiscard]] bool hasCrashed() const;  // ended otherwise than by main() returning
    [[nodiscard]] std::string end() const;  // "signal 11", "exit code 1"
};

// Runs the program once for each list of arguments, `atOnce` at a time; standard input is empty. `told` is
// called for each in their order, as soon as it and all before it have ended, from any thread, one call at a
// time. The processes end with this one.
void runChildren(const std::vector<std::vector<std::string>>& calls, int atOnce,
                 const std::function<void(size_t call, const ChildRun& run)>& told);

}  // namespace knotspan::app
