#include "ui/actions.h"

#include <set>

#include <gtest/gtest.h>

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>

#include "model/formats/format_list.h"
#include "tests/ui/window_harness.h"
#include "ui/document_files.h"
#include "ui/keys_dialog.h"
#include "ui/panel_list.h"
#include "ui/questions.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

TEST(Actions, NoTwoHaveTheSameKey)
{
    std::set<QString> seen;
    for (const ActionInfo& action : actionList())
        for (const QKeySequence& key : action.shortcuts)
            EXPECT_TRUE(seen.insert(key.toString()).second) << key.toString().toStdString();
}

TEST(Actions, EachHasATipAndANameOfItsOwn)
{
    std::set<std::string> ids;
    for (const ActionInfo& action : actionList()) {
        EXPECT_TRUE(ids.insert(action.id).second) << action.id;
        EXPECT_FALSE(std::string(action.tip).empty()) << action.id;
        EXPECT_NE(std::string(action.tip).back(), '.') << action.id;
    }
}

// Whoever changes what they tell of, and however.
TEST(Actions, AreGreyedCheckedAndNamedAsDocumentSelectionAndFrameSay)
{
    Answers answers;
    MainWindow window(answering(answers));
    window.files().openSample("nine-16");
    const auto isEnabled = [&](const char* id) { return window.action(id)->isEnabled(); };
    const auto isChecked = [&](const char* id) { return window.action(id)->isChecked(); };
    EXPECT_FALSE(isEnabled("edit.delete") || isEnabled("edit.undo") || isEnabled("edit.redo"));
    window.selection().setObjects({window.document().scene().objects().begin()->first});
    EXPECT_TRUE(isEnabled("edit.delete") && isEnabled("view.fitSelection"));
    window.action("edit.delete")->trigger();
    EXPECT_TRUE(isEnabled("edit.undo"));
    EXPECT_EQ(window.action("edit.undo")->text(), "&Undo: Delete an object");
    EXPECT_EQ(window.action("edit.undo")->iconText(), "Undo");
    window.document().undo();
    EXPECT_TRUE(isEnabled("edit.redo"));
    EXPECT_EQ(window.action("edit.undo")->text(), "&Undo");

    EXPECT_FALSE(isChecked("view.knots") || isChecked("view.orthographic"));
    Frame frame = window.viewport().frame();
    frame.overlays.knotLines = true;
    frame.camera.orthographic = true;
    window.viewport().setFrame(frame);
    EXPECT_TRUE(isChecked("view.knots") && isChecked("view.orthographic"));
    window.action("view.knots")->trigger();
    EXPECT_FALSE(window.viewport().frame().overlays.knotLines);
    EXPECT_TRUE(window.viewport().frame().camera.orthographic);
}

TEST(Panels, EachHasADockAndALineInTheMenuPanels)
{
    Answers answers;
    const MainWindow window(answering(answers));
    QList<QAction*> lines;
    for (const QMenu* menu : window.findChildren<QMenu*>())
        if (menu->title() == "&Panels")
            lines += menu->actions();
    for (const PanelInfo& panel : panelList()) {
        const auto* dock = window.findChild<QDockWidget*>(panel.name);
        ASSERT_NE(dock, nullptr) << panel.name;
        EXPECT_TRUE(lines.contains(dock->toggleViewAction())) << panel.name;
        EXPECT_EQ(dock->windowTitle(), panel.title);
    }
}

TEST(KeysDialog, ComesUpAgainAfterItWasClosed)
{
    Answers answers;
    MainWindow window(answering(answers));
    for (int k = 0; k < 2; ++k) {
        window.action("help.keys")->trigger();
        auto* dialog = window.findChild<KeysDialog*>();
        ASSERT_NE(dialog, nullptr);
        EXPECT_TRUE(dialog->isVisible());
        dialog->close();
        EXPECT_FALSE(dialog->isVisible());
    }
    EXPECT_EQ(window.findChildren<KeysDialog*>().size(), 1);
}

TEST(Questions, OffersEveryFormat)
{
    const QString reading = readFilters().join('\n');
    const QString writing = writeFilters().join('\n');
    for (const formats::Format& format : formats::all())
        for (const std::string& extension : format.extensions) {
            const QString pattern = "*." + QString::fromStdString(extension);
            EXPECT_EQ(reading.contains(pattern), format.read != nullptr) << extension;
            EXPECT_EQ(writing.contains(pattern), format.write != nullptr) << extension;
        }
}

}  // namespace
}  // namespace knotspan
