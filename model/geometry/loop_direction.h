// Which way round a closed chain of curves runs.
#pragma once

#include "model/geometry/trim_loop.h"

namespace knotspan {

// What a polygon encloses, above zero if it runs anticlockwise.
[[nodiscard]] double signedArea(const std::vector<Vec2>& polygon);

// What the curves enclose, above zero if they run anticlockwise. From a few samples of each, so only near to
// it.
[[nodiscard]] double signedArea(const std::vector<TrimCurve>& curves);

// The other way round: the parameter becomes its negative, so that nothing is rounded.
[[nodiscard]] std::vector<TrimCurve> turnedRound(const std::vector<TrimCurve>& curves);

// An outer loop anticlockwise, a hole clockwise. One that does not end where it starts (it is open, or runs
// around a closed surface) or encloses nothing stays as it is.
[[nodiscard]] TrimLoop oriented(TrimLoop loop);

}  // namespace knotspan
