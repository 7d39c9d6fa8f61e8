// The options of `knotspan measure`, as they are typed and as the measurements take them.
#pragma once

#include <optional>
#include <string>

#include "app/arguments.h"
#include "renderer/measurement/path_measurement.h"

namespace knotspan::app {

// As typed; empty where not given.
struct MeasureTexts {
    std::string file, only, paths, tolerances, evaluators, deform, size, view, sampling;
    bool json = false;
    std::optional<std::string> plot;
    std::optional<int> device;
    int points = 200'000;
    int frames = 5;
    int flight = 0;
};

void addMeasureOptions(CLI::App& command, MeasureTexts& texts);

// All that can be said without the model and the device.
struct MeasureRequest {
    bool paths = true;
    bool evaluators = true;
    std::string view = "iso";
    int flight = 0;                  // how many views around the model in place of that one; 0: none
    PathMeasurementRequest ofPaths;  // but for the camera
};

// Throws CLI::ValidationError for what no list or range has.
[[nodiscard]] MeasureRequest parse(const MeasureTexts& texts);

}  // namespace knotspan::app
