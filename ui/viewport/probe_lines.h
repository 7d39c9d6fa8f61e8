// Probes in the picture: at each the normal as an arrow, the two principal directions as lines across the
// place, all of one size on the picture; at pinned ones their numbers. In front of everything.
#pragma once

#include "renderer/frame.h"
#include "ui/tools/picture_moves.h"
#include "ui/tools/probes.h"

namespace knotspan {

// 0xRRGGBB, apart for colour-blind eyes (Okabe and Ito, 2008).
constexpr std::uint32_t kNormalColour = 0x2fd6a0;
constexpr std::uint32_t kLargestColour = 0xe69f00;   // along the largest curvature
constexpr std::uint32_t kSmallestColour = 0x56b4e9;  // along the smallest

// None at objects that are gone or hidden, and none behind the eye.
[[nodiscard]] std::vector<Stroke> probeLines(const Scene& scene, const Probes& probes,
                                             const PictureView& view);

}  // namespace knotspan
