// The measurement of paths as people and plots read it; for programs there is renderer/measurement.
#pragma once

#include <string>
#include <vector>

#include "renderer/measurement/measurement_json.h"
#include "ui/plots/plot.h"

namespace knotspan::app {

[[nodiscard]] std::string tableOf(const PathReport& report);
[[nodiscard]] std::vector<Plot> plotsOf(const PathReport& report);  // one for each motion

}  // namespace knotspan::app
