#include "tests/resources/shell.h"

#include <array>
#include <cstdio>

#include <sys/wait.h>

namespace knotspan::testing {

ShellRun shell(const std::string& command)
{
    ShellRun run;
    const std::string all =
        "unset DISPLAY WAYLAND_DISPLAY QT_QPA_PLATFORM GTEST_OUTPUT; { " + command + "; } 2>&1 </dev/null";
    FILE* pipe = ::popen(all.c_str(), "r");
    if (pipe == nullptr)
        return run;
    std::array<char, 4096> block{};
    while (const size_t count = std::fread(block.data(), 1, block.size(), pipe))
        run.output.append(block.data(), count);
    const int status = ::pclose(pipe);
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return run;
}

bool hasTool(const std::string& name)
{
    return shell("command -v " + name).exitCode == 0;
}

}  // namespace knotspan::testing
