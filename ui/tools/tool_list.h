// The tools for the left mouse button: one file and one line each.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/tools/tool.h"

namespace knotspan {

struct ToolInfo {
    std::string name;         // "move-control-point"
    std::string description;  // a sentence for the help
    std::unique_ptr<Tool> (*make)();
};

// The first is the one that a new window starts with.
[[nodiscard]] const std::vector<ToolInfo>& tools();

}  // namespace knotspan
