// The weights of selected control points, set or scaled.
#pragma once

#include "model/scene/edit.h"
#include "model/sculpting/point_selection.h"

namespace knotspan {

// A surface takes any finite weight above zero. What the hand sets stays between these: with weights further
// apart a surface is no more than its heaviest points, and float evaluation loses what the others say.
constexpr double kLeastWeight = 1e-6;
constexpr double kMostWeight = 1e6;

// For both the selection is of this scene (PointSelection::keepOnly), and positions stay. Objects whose
// weights are these already are left out of the edit. Refuses, with a sentence that says the bounds, what
// would lie beyond them.
[[nodiscard]] Result<Edit> withWeights(const Scene& scene, const PointSelection& selection, double weight);
[[nodiscard]] Result<Edit> withWeightsScaled(const Scene& scene, const PointSelection& selection,
                                             double factor);

// The factors that withWeightsScaled() takes, for a drag to stop at: those that leave all selected weights
// within the bounds. None does (low > high) where the selected weights differ too much already.
struct FactorRange {
    double low = 0;
    double high = 0;
};
[[nodiscard]] FactorRange factorRange(const Scene& scene, const PointSelection& selection);

}  // namespace knotspan
