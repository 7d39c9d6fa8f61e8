// The options that tell a shading what it may be told (renderer/scene/look.h).
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "renderer/frame.h"

namespace knotspan::app {

struct LookTexts {
    std::optional<int> stripes;
    std::optional<double> stripeAngle;
    std::string matcap, curvature, range, pull, checker;
    std::optional<int> squares;
    std::optional<double> squareLength;
    std::optional<double> draft;
};

void addLookOptions(CLI::App& command, LookTexts& texts);

// Throws CLI::ValidationError for what no list or range has, and for what the shading does not read.
[[nodiscard]] Look parseLook(const LookTexts& texts, Shading shading);

}  // namespace knotspan::app
