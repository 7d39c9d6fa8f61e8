// What Match tells before it is applied: how far what moves, and how well the sides meet then.
#pragma once

#include <QString>

#include "model/matching/scene_match.h"

namespace knotspan {

// "Now: G0, largest angle 5.03°, gap 0.0001 mm."
[[nodiscard]] QString edgeReport(const Scene& scene, const ObjectEdge& edge);

// A line on what is left, and one for each side on how far and which rows; `scene` is the one before.
[[nodiscard]] QString matchReport(const Scene& scene, const ObjectEdge& edge, const SceneMatch& match);

// "Also changes: u start of "Port aft" with "Port midships": G2 to G0." and "Becomes naked: ...", the first
// three of each; empty where nothing else changes for the worse.
[[nodiscard]] QString effectsReport(const Scene& scene, const SideEffects& effects);

}  // namespace knotspan
