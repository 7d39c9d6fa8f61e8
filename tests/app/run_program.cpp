#include "tests/app/run_program.h"

#include <algorithm>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support.h"

namespace knotspan::testing {
namespace {

[[noreturn]] void becomeProgram(std::vector<char*> argv, const std::string& input, const std::string& output,
                                const std::string& messages)
{
    ::dup2(::open(input.c_str(), O_RDONLY), STDIN_FILENO);
    ::dup2(::open(output.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(::open(messages.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        ::unsetenv(display);
    ::execv(argv[0], argv.data());
    ::_exit(127);
}

void expectOneLine(const ProgramRun& run, const std::string& call)
{
    EXPECT_EQ(run.output, "") << call;
    EXPECT_EQ(std::count(run.messages.begin(), run.messages.end(), '\n'), 1) << call << run.messages;
    EXPECT_EQ(run.messages.rfind("knotspan: ", 0), 0U) << call << run.messages;
}

std::string callOf(const std::vector<std::string>& arguments)
{
    std::string call = "knotspan";
    for (const std::string& argument : arguments)
        call += " " + argument;
    return call + "\n";
}

}  // namespace

ProgramRun runProgram(const std::vector<std::string>& arguments, const std::string& input)
{
    const TemporaryFolder folder;
    const std::string output = (folder / "output").string();
    const std::string messages = (folder / "messages").string();
    std::vector<std::string> texts{KNOTSPAN_PROGRAM};
    texts.insert(texts.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& text : texts)
        argv.push_back(text.data());
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0)
        becomeProgram(std::move(argv), input, output, messages);
    int status = 0;
    ::waitpid(child, &status, 0);
    const int exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {exitCode, readFile(output), readFile(messages)};
}

void expectWrongCall(const std::vector<std::string>& arguments)
{
    const ProgramRun run = runProgram(arguments);
    EXPECT_EQ(run.exitCode, 2) << callOf(arguments) << run.messages;
    expectOneLine(run, callOf(arguments));
}

void expectFailure(const std::vector<std::string>& arguments, const std::string& place)
{
    const ProgramRun run = runProgram(arguments);
    EXPECT_EQ(run.exitCode, 1) << callOf(arguments) << run.messages;
    expectOneLine(run, callOf(arguments));
    EXPECT_NE(run.messages.find(place), std::string::npos) << run.messages;
}

}  // namespace knotspan::testing
