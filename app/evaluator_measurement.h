// What each evaluator is worth on this machine: how many points a second it gives, and how far off they are.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/measured_points.h"
#include "renderer/renderer.h"

namespace knotspan::app {

enum class Processor : std::uint8_t { cpu, gpu };

// An error is the distance of a position from the exact one, as a part of the local size: the largest
// coordinate of the KSQuad's control points, relative to the surface's own origin.
struct EvaluatorRow {
    std::string evaluator;  // its name, or "grid": the fast evaluation of grids
    Precision precision{};
    Processor processor{};
    bool automatic = false;             // what `auto` takes
    std::string unavailable;            // why there are no figures, as a sentence; empty: there are
    double millionPointsPerSecond = 0;  // positions, both first derivatives and unit normals
    double errorMax = 0;
    double errorMean = 0;
};

[[nodiscard]] double nanosecondsPerPoint(const EvaluatorRow& row);
// The error in float's or double's last place of a number as large as the local size.
[[nodiscard]] double inUnits(const EvaluatorRow& row, double error);

// With a renderer that holds the points' scene, or none and the reason. `progress` hears which row comes.
struct EvaluatorRequest {
    const MeasuredPoints& points;
    int degree;  // the largest, which `auto` goes by
    Renderer* renderer;
    std::string whyNoRenderer;
    std::function<void(size_t row, size_t rows)> progress;
};
// Every evaluator in float and double, on the CPU (one thread; tables of spans and nets are made beforehand)
// and the GPU (without transfers).
[[nodiscard]] std::vector<EvaluatorRow> measureEvaluators(const EvaluatorRequest& request);

}  // namespace knotspan::app
