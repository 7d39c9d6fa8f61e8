// Light or dark, as the system has it or as the user wants it; all windows follow at once.
#pragma once

#include <QPalette>

namespace knotspan {

enum class Appearance { system, light, dark };

[[nodiscard]] Appearance appearance();
// From now on, and kept. A QApplication runs.
void setAppearance(Appearance wanted);
// What was kept; when the program starts, before its first window.
void restoreAppearance();

// The colours of the two that are our own.
[[nodiscard]] QPalette lightPalette();
[[nodiscard]] QPalette darkPalette();

}  // namespace knotspan
