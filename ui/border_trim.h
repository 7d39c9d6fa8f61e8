// Edit > Trim by selected: a surface trimmed by the borders of others that lie over it in the view.
#pragma once

#include "model/trimming/loop_combining.h"

namespace knotspan {

class MainWindow;

// The surface that was selected last, by the others, as one step; else the status line says why not.
void trimBySelected(MainWindow& window, KeptSide side);

}  // namespace knotspan
