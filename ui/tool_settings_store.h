// What the user told the tools, kept from one session to the next: all but what belongs to one model (axis,
// falloff, symmetry).
#pragma once

#include "ui/tools/tool.h"

namespace knotspan {

// What is missing or makes no sense there is as in ToolSettings.
[[nodiscard]] ToolSettings storedToolSettings();
void storeToolSettings(const ToolSettings& settings);

}  // namespace knotspan
