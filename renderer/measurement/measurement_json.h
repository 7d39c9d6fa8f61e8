// A measurement of paths as programs and bug reports read it: what `knotspan measure --json` prints and what
// the window copies.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "renderer/measurement/path_measurement.h"

namespace knotspan {

struct PathReport {
    std::string file;                  // its name without folders, or what the model is called
    std::optional<DeviceInfo> device;  // none: there is none
    PathMeasurementRequest request;
    std::vector<PathRow> rows;
    size_t ksquads = 0;  // of what is visible
};

[[nodiscard]] size_t visibleKsQuads(const Scene& scene);

// A row that was not measured says why under "unavailable".
[[nodiscard]] nlohmann::ordered_json jsonOf(const PathReport& report);

// Such a file's text. What is no UTF-8 in it is replaced.
[[nodiscard]] std::string textOf(const nlohmann::ordered_json& json);

}  // namespace knotspan
