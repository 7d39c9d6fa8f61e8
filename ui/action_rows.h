// What the files with the rows of actions share.
#pragma once

#include "ui/actions.h"
#include "ui/document_files.h"
#include "ui/main_window.h"
#include "ui/speed_dialog.h"

// Marks a row's texts for translation.
#define TEXT(text) QT_TRANSLATE_NOOP("knotspan::Actions", text)

namespace knotspan {

using Window = MainWindow;

inline bool hasSelection(Window& window)
{
    return !window.selection().objects().empty();
}

// Of surfaces or of meshes, which are looked at only.
inline bool hasAnySelection(Window& window)
{
    return hasSelection(window) || !window.selection().meshes().empty();
}

// Brings up the window's only dialog of its kind, made when it is first wanted. The window deletes it before
// the document.
template <class Dialog, class Make>
Dialog& broughtUp(Window& window, const Make& make)
{
    auto* dialog = window.findChild<Dialog*>(QString(), Qt::FindDirectChildrenOnly);
    if (dialog == nullptr)
        dialog = make();
    dialog->show();
    dialog->raise();
    dialog->activateWindow();
    return *dialog;
}

inline SpeedDialog& speedDialog(Window& window)
{
    return broughtUp<SpeedDialog>(window, [&] {
        return new SpeedDialog(window.document(), window.viewport(), window.files().questions(), &window);
    });
}

}  // namespace knotspan
