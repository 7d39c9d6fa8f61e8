// The menu Edit.
#include "ui/action_rows.h"

namespace knotspan {

namespace {

void takeBack(Window& window)
{
    if (!window.viewport().cancelDrag())
        window.document().undo();
}

void escape(Window& window)
{
    if (!window.viewport().cancelDrag())
        window.selection().clear();
}

void selectAll(Window& window)
{
    std::set<ObjectId> visible;
    for (const auto& [id, object] : window.document().scene().objects())
        if (object->visible)
            visible.insert(id);
    window.selection().setObjects(std::move(visible));
}

void deleteSelected(Window& window)
{
    const std::set<ObjectId>& objects = window.selection().objects();
    Edit edit;
    for (const ObjectId id : objects)
        edit.set(id, nullptr);
    const int count = static_cast<int>(objects.size());
    window.document().apply(edit, count == 1 ? MainWindow::tr("Delete an object")
                                             : MainWindow::tr("Delete %1 objects").arg(count));
}

}  // namespace

const std::vector<ActionInfo>& editActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "edit.undo",
         .text = TEXT("&Undo"),
         .shortcuts = {QKeySequence::Undo},
         .tip = TEXT("Take the last step back"),
         .run = [](Window& w, bool) { takeBack(w); },
         .isEnabled = [](Window& w) { return w.document().canUndo(); },
         .step = [](Window& w) { return w.document().undoText(); }},
        {.id = "edit.redo",
         .text = TEXT("&Redo"),
         .shortcuts = {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")},
         .tip = TEXT("Do the step again that was taken back"),
         .run = [](Window& w, bool) { w.document().redo(); },
         .isEnabled = [](Window& w) { return w.document().canRedo(); },
         .step = [](Window& w) { return w.document().redoText(); }},
        {.id = "edit.selectAll",
         .text = TEXT("Select a&ll"),
         .shortcuts = {QKeySequence::SelectAll},
         .tip = TEXT("Select every visible object"),
         .run = [](Window& w, bool) { selectAll(w); },
         .separated = true},
        {.id = "edit.deselect",
         .text = TEXT("&Deselect"),
         .shortcuts = {QKeySequence(Qt::Key_Escape)},
         .tip = TEXT("Take a running drag back; without one, select nothing"),
         .run = [](Window& w, bool) { escape(w); }},
        {.id = "edit.delete",
         .text = TEXT("D&elete"),
         .shortcuts = {QKeySequence(Qt::Key_Delete)},
         .tip = TEXT("Remove the selected objects"),
         .run = [](Window& w, bool) { deleteSelected(w); },
         .isEnabled = hasSelection},
    };
    return kList;
}

}  // namespace knotspan
