// The menu File.
#include "ui/action_rows.h"
#include "ui/document_files.h"
#include "ui/export_dialog.h"

namespace knotspan {

namespace {

void exportMesh(Window& window)
{
    broughtUp<ExportDialog>(
        window, [&] { return new ExportDialog(window.document(), window.files().questions(), &window); });
}

}  // namespace

const std::vector<ActionInfo>& fileActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "file.new",
         .text = TEXT("&New"),
         .shortcuts = {QKeySequence::New},
         .tip = TEXT("Begin with an empty model in place of this one"),
         .run = [](Window& w, bool) { w.files().startNew(); }},
        {.id = "file.open",
         .text = TEXT("&Open…"),
         .shortcuts = {QKeySequence::Open},
         .tip = TEXT("Open a model in place of this one"),
         .run = [](Window& w, bool) { w.files().askAndOpen(); }},
        {.id = "file.add",
         .text = TEXT("&Add…"),
         .shortcuts = {QKeySequence("Ctrl+Shift+O")},
         .tip = TEXT("Add the objects of another file to this model"),
         .run = [](Window& w, bool) { w.files().askAndAdd(); }},
        {.id = "file.reload",
         .text = TEXT("&Reload"),
         .shortcuts = {QKeySequence::Refresh},
         .tip = TEXT("Read the model's file again; Undo brings the model back as it is now"),
         .run = [](Window& w, bool) { w.files().reload(); },
         .isEnabled = [](Window& w) { return !w.document().source().empty(); }},
        {.id = "file.save",
         .text = TEXT("&Save"),
         .shortcuts = {QKeySequence::Save},
         .tip = TEXT("Write the model to its file"),
         .run = [](Window& w, bool) { w.files().save(); },
         .separated = true},
        {.id = "file.saveAs",
         .text = TEXT("Save &as…"),
         .shortcuts = {QKeySequence("Ctrl+Shift+S")},
         .tip = TEXT("Write the model to another file"),
         .run = [](Window& w, bool) { w.files().saveAs(); }},
        {.id = "file.export",
         .text = TEXT("&Export mesh…"),
         .shortcuts = {QKeySequence("Ctrl+E")},
         .tip = TEXT("Write the visible surfaces as triangles, at an accuracy that you choose"),
         .run = [](Window& w, bool) { exportMesh(w); }},
        {.id = "file.quit",
         .text = TEXT("&Quit"),
         .shortcuts = {QKeySequence("Ctrl+Q")},
         .tip = TEXT("Close the window"),
         .run = [](Window& w, bool) { w.close(); },
         .separated = true},
    };
    return kList;
}

}  // namespace knotspan
