// What an orbit measured: as a table in Markdown, and as JSON.
#pragma once

#include "benchmarks/frames/orbit.h"

namespace knotspan::benchmarks {

[[nodiscard]] std::string tableOf(const std::string& device, const OrbitRequest& request,
                                  const std::vector<OrbitRow>& rows);
[[nodiscard]] std::string jsonOf(const std::string& device, const OrbitRequest& request,
                                 const std::vector<OrbitRow>& rows);

}  // namespace knotspan::benchmarks
