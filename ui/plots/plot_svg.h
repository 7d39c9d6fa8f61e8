// Plots as one SVG file, one below the other.
#pragma once

#include <vector>

#include "ui/plots/plot.h"

class QIODevice;

namespace knotspan {

// Each marker is a group of class `marker`, each curve a line of class `curve`. False where the device
// refused something.
[[nodiscard]] bool writeSvg(const std::vector<Plot>& plots, QIODevice& device);

}  // namespace knotspan
