// Which instruction sets the fast evaluation may use: chosen while running, so that one binary runs
// everywhere.
#pragma once

#include <string>
#include <vector>

namespace knotspan {

// The names of those that this machine can run, best first: "AVX3", "AVX2", "SSE4", ...
[[nodiscard]] std::vector<std::string> simdTargets();
[[nodiscard]] std::string simdTargetInUse();

// One of simdTargets() for the rest of the program, any other name for the best: for tests and measurements.
// Not while another thread evaluates.
void useSimdTarget(const std::string& name);

}  // namespace knotspan
