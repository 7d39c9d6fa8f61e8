// The measurement of paths as people, programs and plots read it.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "renderer/measurement/path_measurement.h"
#include "ui/plots/plot.h"

namespace knotspan::app {

struct PathReport {
    std::string file;    // its name without folders
    std::string device;  // empty: none
    PathMeasurementRequest request;
    std::vector<PathRow> rows;
};

[[nodiscard]] std::string tableOf(const PathReport& report);
[[nodiscard]] nlohmann::ordered_json jsonOf(const PathReport& report);
[[nodiscard]] std::vector<Plot> plotsOf(const PathReport& report);  // one for each motion

}  // namespace knotspan::app
