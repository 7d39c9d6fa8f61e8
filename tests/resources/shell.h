// Commands as a user types them.
#pragma once

#include <string>

namespace knotspan::testing {

struct ShellRun {
    int exitCode = -1;
    std::string output;  // and messages
};

// Without a display.
[[nodiscard]] ShellRun shell(const std::string& command);
[[nodiscard]] bool hasTool(const std::string& name);

}  // namespace knotspan::testing

#define KNOTSPAN_NEED_TOOL(name, package)    \
    if (!::knotspan::testing::hasTool(name)) \
    GTEST_SKIP() << "no " name " here: install " package " to run this test"
