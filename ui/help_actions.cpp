// The menu Help.
#include <QMessageBox>

#include "ui/action_rows.h"
#include "ui/command_palette.h"
#include "ui/keys_dialog.h"

namespace knotspan {

namespace {

void showPalette(Window& window)
{
    broughtUp<CommandPalette>(window, [&] { return new CommandPalette(window.commands(), &window); });
}

void showKeys(Window& window)
{
    broughtUp<KeysDialog>(window,
                          [&] { return new KeysDialog(window.commandKeys(), window.viewport(), &window); });
}

void showAbout(Window& window)
{
    auto* box = new QMessageBox(&window);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(MainWindow::tr("About Knotspan"));
    box->setText(MainWindow::tr(
        "<b>Knotspan</b><p>Shape free-form surfaces and see the exact NURBS: the graphics device "
        "evaluates the surfaces themselves.</p>"));
    const Renderer* renderer = window.viewport().renderer();
    box->setInformativeText(
        renderer == nullptr
            ? MainWindow::tr("No graphics device draws at the moment.")
            : MainWindow::tr("Drawing on %1.").arg(QString::fromStdString(renderer->deviceName())));
    box->open();
}

}  // namespace

const std::vector<ActionInfo>& helpActions()
{
    static const std::vector<ActionInfo> kList = {
        {.id = "help.palette",
         .text = TEXT("&Find an action…"),
         .shortcuts = {QKeySequence("Ctrl+K")},
         .tip = TEXT("Type a few letters of what you want to do, and do it"),
         .run = [](Window& w, bool) { showPalette(w); }},
        {.id = "help.keys",
         .text = TEXT("&Keys and mouse"),
         .shortcuts = {QKeySequence("H"), QKeySequence("F1")},
         .tip = TEXT("List every key and what the mouse does, and change them"),
         .run = [](Window& w, bool) { showKeys(w); }},
        {.id = "help.start",
         .text = TEXT("&Start page"),
         .tip = TEXT("Show the files that were open last and the samples in place of the picture"),
         .run = [](Window& w, bool on) { w.showStartPage(on); },
         .isChecked = [](Window& w) { return w.isStartPageShown(); }},
        {.id = "help.benchmark",
         .text = TEXT("&Benchmark"),
         .tip =
             TEXT("Fly around the model on every path that this device can run, and report what each costs"),
         .run = [](Window& w, bool) { speedDialog(w).measure(SpeedDialog::Views::flight); },
         .separated = true},
        {.id = "help.about",
         .text = TEXT("&About Knotspan"),
         .tip = TEXT("What this program is, and on which device it draws"),
         .run = [](Window& w, bool) { showAbout(w); }},
    };
    return kList;
}

}  // namespace knotspan
