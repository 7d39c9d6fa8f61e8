// The measurement of evaluators as people, programs and plots read it.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/evaluator_measurement.h"
#include "ui/plots/plot.h"

namespace knotspan::app {

struct EvaluatorReport {
    std::string file;    // its name without folders
    std::string device;  // empty: none
    std::string simd;    // the instruction set in use
    size_t points = 0;   // as asked for
    size_t exactPoints = 0;
    size_t surfaces = 0;
    size_t ksquads = 0;
    int lowestDegree = 0;
    int highestDegree = 0;
    std::vector<EvaluatorRow> rows;
};

[[nodiscard]] std::string tableOf(const EvaluatorReport& report);
[[nodiscard]] nlohmann::ordered_json jsonOf(const EvaluatorReport& report);
[[nodiscard]] Plot plotOf(const EvaluatorReport& report);  // error against time per point

}  // namespace knotspan::app
