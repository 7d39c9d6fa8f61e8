// The options of `knotspan render`, as they are typed and as the renderer takes them.
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/arguments.h"
#include "app/look_options.h"
#include "model/scene/deformation.h"
#include "renderer/frame.h"

namespace knotspan::app {

// As typed; empty where not given.
struct RenderTexts {
    std::string file, output, size, path, culling, sampling, evaluator, view, eye, target, up, shading,
        deform;
    std::string against, stats;
    LookTexts look;
    std::optional<double> tolerance;
    double fov = 35;
    int frames = 1;
    std::optional<int> device;
    bool orthographic = false, net = false, knots = false, outlines = false, sharpEdges = false,
         friends = false, countWrong = false;
};

void addRenderOptions(CLI::App& command, RenderTexts& texts);

// All that can be said without the model and the device.
struct RenderRequest {
    PixelSize size;
    std::optional<PathId> path;  // none: the best that the device can run
    CullSet culling;
    SamplingRule sampling;
    Evaluator evaluator = Evaluator::automatic;
    Shading shading = Shading::shaded;
    Look look;
    Deformation deformation = Deformation::none;
    std::optional<Vec3> eye, target, up;
};

// Throws CLI::ValidationError for what no list or range has.
[[nodiscard]] RenderRequest parse(const RenderTexts& texts);

// The camera for a model that shows something.
[[nodiscard]] Camera cameraFor(const RenderTexts& texts, const RenderRequest& request, const Scene& scene);

}  // namespace knotspan::app
