// The tools for the left mouse button: one file and one line each.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/tools/tool.h"

namespace knotspan {

struct ToolInfo {
    const char* name;  // "select"
    const char* text;  // for its action, with a mnemonic
    const char* key;   // its shortcut
    const char* tip;   // a sentence without a full stop
    const char* hint;  // what the hand does with it, for the status line
    std::unique_ptr<Tool> (*make)();
};

// The first is the one that a new window starts with.
[[nodiscard]] const std::vector<ToolInfo>& tools();

}  // namespace knotspan
