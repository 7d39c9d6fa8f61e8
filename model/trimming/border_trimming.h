// A face trimmed by the border of another one, as an eye sees it lie over the first.
#pragma once

#include "model/trimming/loop_combining.h"
#include "model/trimming/seen_borders.h"

namespace knotspan {

struct BorderTrim {
    std::vector<TrimLoop> loops;  // of what is left
    double error = 0;             // the largest distance found, in space, from the exact projection
};

// The cutter's borders (seenBorders) fall onto the sheet of the face that is nearest to the eye, within
// `tolerance`, as projectedOnto and trimmedBy say. Inside is what lies within any of
// them. Fails, with a sentence, also where a border does not meet the face.
[[nodiscard]] Result<BorderTrim> trimmedByBorder(const PlacedFace& face, const PlacedFace& cutter,
                                                 const Sight& sight, double tolerance, KeptSide side);

// The loops of all parts of a surface. Fails, with a sentence, where parts overlap.
[[nodiscard]] Result<std::vector<TrimLoop>> joinedParts(const std::vector<std::vector<TrimLoop>>& parts,
                                                        const NurbsSurface& surface);

}  // namespace knotspan
