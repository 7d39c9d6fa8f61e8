// A trimmed surface trimmed once more, by a closed curve: what of it lies inside, or outside.
#pragma once

#include "model/trimming/loop_reading.h"

namespace knotspan {

enum class KeptSide { inside, outside };

// The loops of what `loops` leave on one side of the curve. The curve may cross loops, the domain's border
// and a seam: loops are cut there and joined with its parts, exactly but for where they meet, which is found
// to 1e-12 of the domain. Loops that it does not touch are kept to the bit, or go as a whole. Fails, with a
// sentence, where the curve is open, crosses itself or runs along a loop, where nothing would be left, or
// all.
[[nodiscard]] Result<std::vector<TrimLoop>> trimmedBy(const std::vector<TrimCurve>& curve,
                                                      const std::vector<TrimLoop>& loops,
                                                      const NurbsSurface& surface, KeptSide side);

// Without what lies inside other loops: holes, and islands in them. Nothing where there are only holes. Loops
// around a closed surface stay.
[[nodiscard]] std::vector<TrimLoop> withoutHoles(const std::vector<TrimLoop>& loops,
                                                 const NurbsSurface& surface);

}  // namespace knotspan
