// Background that a picture shows where a closed model should be.
#pragma once

#include "renderer/renderer.h"

namespace knotspan {

// Pixels of the background among those that the model covers for sure in a picture that is off by at most
// `errorPx` (model/analysis/silhouette_mask.h): the tolerance, or the largest error measured where that is
// more, so that an error of the outline is not counted as a hole. Means something only where the visible
// objects together are a closed model; `shown` is captureKsQuads() of this scene, drawn as this frame.
// Takes about as long as drawing the model on the CPU.
[[nodiscard]] std::uint64_t countLeaks(const Scene& scene, const Frame& frame, const KsQuadIndices& shown,
                                       double errorPx);

}  // namespace knotspan
