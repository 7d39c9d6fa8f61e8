// What the user told the picture, kept from one session to the next: how shadings look, tolerance and
// culling, combs and the section's axis. Which shading shows, and what belongs to one model (where the
// section is, what is compared), is not.
#pragma once

#include "ui/viewport/viewport.h"

namespace knotspan {

// What is missing or makes no sense there stays as it is.
void restorePicture(Viewport& viewport);
void storePicture(Viewport& viewport);

}  // namespace knotspan
