// What is to be measured, from the command line.
#pragma once

#include <optional>

#include "benchmarks/frames/orbit.h"

namespace knotspan::benchmarks {

struct Arguments {
    OrbitRequest orbit;
    bool json = false;
};

// Nothing where the program is to end with `exitCode`: help was asked for, or the call was wrong, and that
// has been said.
[[nodiscard]] std::optional<Arguments> parseArguments(int argc, const char* const* argv, int& exitCode);

}  // namespace knotspan::benchmarks
