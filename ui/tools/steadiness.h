// How steady hands are taken to be.
#pragma once

namespace knotspan {

// A hand that only clicks trembles less than this, in pixels.
constexpr double kStillPx = 3;
// What a hand's way counts while it holds Shift.
constexpr double kFine = 0.1;

}  // namespace knotspan
