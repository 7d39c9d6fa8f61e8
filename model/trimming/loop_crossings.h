// Which trim loops cross each other or themselves: what is inside is then told by even-odd alone, and worth a
// word.
#pragma once

#include "model/trimming/trim_region.h"

namespace knotspan {

// Sentences, one for each loop or pair of loops. Loops that touch, run along each other, or meet
// where pieces end (a knot line, for one), do not cross.
// Looks at pieces that share a KSQuad and heights; after a million such pairs no more.
[[nodiscard]] std::vector<std::string> crossingsOf(const TrimRegion& region);

}  // namespace knotspan
