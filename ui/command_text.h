// What a command of the window says of itself. A command is an action with a name of its own ("view.fit", its
// objectName): those of actionList(), and the ones that show panels.
#pragma once

#include <QAction>

namespace knotspan {

// Its text without the mnemonic and the dots that promise a dialog.
[[nodiscard]] QString plainTextOf(const QAction& command);

// The part of its name before the dot, in the user's language: "View".
[[nodiscard]] QString menuTitleOf(const QAction& command);

// All its keys, as people read them; empty where it has none.
[[nodiscard]] QString keysTextOf(const QAction& command);

}  // namespace knotspan
