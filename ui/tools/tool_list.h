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
    // What the hand does with it, for the status line; "{view.nets}" stands for the key of that action.
    const char* hint;
    std::unique_ptr<Tool> (*make)();
    bool takesAll = false;  // drags that begin on nothing, too
};

// The first is the one that a new window starts with.
[[nodiscard]] const std::vector<ToolInfo>& tools();

}  // namespace knotspan
