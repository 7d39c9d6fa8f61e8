// Runs the real program as a user's shell would.
#pragma once

#include <string>
#include <vector>

namespace knotspan::testing {

struct ProgramRun {
    int exitCode = -1;  // 128 + the signal's number where one ended it
    std::string output;
    std::string messages;  // standard error
};

// Without a display: a command that needs one fails. `input`: a file for standard input.
[[nodiscard]] ProgramRun runProgram(const std::vector<std::string>& arguments,
                                    const std::string& input = "/dev/null");

// Exit code 2, nothing on standard output, one line of message.
void expectWrongCall(const std::vector<std::string>& arguments);

// Exit code 1, nothing on standard output, one line of message that holds `place`.
void expectFailure(const std::vector<std::string>& arguments, const std::string& place);

}  // namespace knotspan::testing
