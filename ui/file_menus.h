// The menus of the menu File that are lists of models.
#pragma once

class QMenu;

namespace knotspan {

class DocumentFiles;

// Both add themselves to `menu`; `files`, which opens what is chosen, outlives it.
void addSamplesMenu(QMenu& menu, DocumentFiles& files);
// Filled anew each time it opens.
void addRecentMenu(QMenu& menu, DocumentFiles& files);

}  // namespace knotspan
