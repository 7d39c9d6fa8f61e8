// Keys that the user gives to actions: at once, kept, and nobody loses one unasked.
#include <gtest/gtest.h>

#include <QAction>
#include <QComboBox>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <QTextBrowser>
#include <QTreeWidget>

#include "tests/ui/window_harness.h"
#include "ui/actions.h"
#include "ui/command_keys.h"
#include "ui/command_text.h"
#include "ui/keys_dialog.h"
#include "ui/tools/tool_list.h"
#include "ui/viewport/navigation_presets.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

class CommandKeysTest : public ::testing::Test {
protected:
    void TearDown() override { QSettings().clear(); }

    [[nodiscard]] CommandKeys& keys() { return window->commandKeys(); }
    [[nodiscard]] QAction& action(const char* id) { return *window->action(id); }
    void reopen()
    {
        window.reset();
        window = std::make_unique<MainWindow>(answering(answers));
    }

    Answers answers;
    std::unique_ptr<MainWindow> window = std::make_unique<MainWindow>(answering(answers));
};

TEST_F(CommandKeysTest, AKeyWorksAtOnceAndInTheNextWindow)
{
    window->show();
    window->activateWindow();
    QApplication::setActiveWindow(window.get());
    keys().assign(action("view.knots"), {QKeySequence("Ctrl+Alt+L")});
    QTest::keySequence(window.get(), QKeySequence("K"));
    EXPECT_FALSE(window->viewport().frame().overlays.knotLines);
    QTest::keySequence(window.get(), QKeySequence("Ctrl+Alt+L"));
    EXPECT_TRUE(window->viewport().frame().overlays.knotLines);
    EXPECT_TRUE(action("view.knots").toolTip().contains("Ctrl+Alt+L"));
    reopen();
    EXPECT_EQ(action("view.knots").shortcuts(), KeyList{QKeySequence("Ctrl+Alt+L")});
    EXPECT_TRUE(keys().isChanged(action("view.knots")));
    EXPECT_FALSE(keys().isChanged(action("view.nets")));
    keys().resetAll();
    EXPECT_EQ(action("view.knots").shortcuts(), KeyList{QKeySequence("K")});
    EXPECT_TRUE(QSettings().value("keys/view.knots").isNull());
}

TEST_F(CommandKeysTest, AnActionWithoutKeysStaysWithoutThem)
{
    keys().assign(action("view.fit"), {});
    reopen();
    EXPECT_TRUE(action("view.fit").shortcuts().isEmpty());
    EXPECT_FALSE(action("view.fit").toolTip().contains('('));
}

TEST_F(CommandKeysTest, AConflictNamesWhoHasTheKeyOrOneThatBeginsAlike)
{
    EXPECT_TRUE(keys().conflicts(action("view.fit"), {QKeySequence("Ctrl+Alt+L")}).empty());
    EXPECT_TRUE(keys().conflicts(action("view.fit"), {QKeySequence("F")}).empty());  // its own
    const auto exact = keys().conflicts(action("view.fit"), {QKeySequence("K")});
    ASSERT_EQ(exact.size(), 1U);
    EXPECT_EQ(exact.front().by, &action("view.knots"));
    const auto alike = keys().conflicts(action("view.fit"), {QKeySequence("K, L")});
    ASSERT_EQ(alike.size(), 1U);
    EXPECT_EQ(alike.front().had, QKeySequence("K"));
    const auto panel = keys().conflicts(action("view.fit"), {QKeySequence("D")});
    ASSERT_EQ(panel.size(), 1U);
    EXPECT_EQ(panel.front().by->objectName(), "view.tool-dock");
    const auto menu = keys().conflicts(action("view.fit"), {QKeySequence("Alt+F")});
    ASSERT_EQ(menu.size(), 1U);
    EXPECT_EQ(plainTextOf(*menu.front().by), "File");
}

TEST_F(CommandKeysTest, NoActionComesWithAKeyThatAnotherHas)
{
    for (QAction* command : keys().commands())
        for (const KeyConflict& conflict : keys().conflicts(*command, command->shortcuts()))
            ADD_FAILURE() << conflict.had.toString().toStdString() << " of "
                          << command->objectName().toStdString();
}

TEST_F(CommandKeysTest, WhoLosesAKeyKeepsItsOthersAndGetsItBackByReset)
{
    keys().assign(action("view.fit"), {QKeySequence("Ctrl+Y")});
    EXPECT_EQ(action("edit.redo").shortcuts(), KeyList{QKeySequence("Ctrl+Shift+Z")});
    reopen();
    EXPECT_EQ(action("edit.redo").shortcuts(), KeyList{QKeySequence("Ctrl+Shift+Z")});
    EXPECT_EQ(action("view.fit").shortcuts(), KeyList{QKeySequence("Ctrl+Y")});
    keys().resetAll();
    EXPECT_EQ(action("edit.redo").shortcuts().size(), 2);
    for (QAction* command : keys().commands())
        EXPECT_FALSE(keys().isChanged(*command)) << command->objectName().toStdString();
}

TEST_F(CommandKeysTest, AStoredKeyCountsBeforeOneThatALaterVersionComesWith)
{
    QSettings().setValue("keys/view.fit", QStringList{"K"});  // nobody took it from view.knots
    reopen();
    EXPECT_EQ(action("view.fit").shortcuts(), KeyList{QKeySequence("K")});
    EXPECT_TRUE(action("view.knots").shortcuts().isEmpty());
}

TEST_F(CommandKeysTest, TheStatusLineNamesTheKeysThatCount)
{
    const auto* hint = window->findChild<QLabel*>("hint");
    keys().assign(action("view.nets"), {QKeySequence("Ctrl+Alt+L")});
    EXPECT_TRUE(hint->text().contains("(Ctrl+Alt+L: of all)")) << hint->text().toStdString();
    keys().assign(action("view.nets"), {});
    EXPECT_TRUE(hint->text().contains("(\"All control nets\": of all)")) << hint->text().toStdString();
    for (const ToolInfo& tool : tools()) {
        window->viewport().setTool(tool.name);
        EXPECT_FALSE(hint->text().contains('{')) << hint->text().toStdString();
    }
}

class KeysDialogTest : public CommandKeysTest {
protected:
    void SetUp() override
    {
        window->action("help.keys")->trigger();
        dialog = window->findChild<KeysDialog*>();
        ASSERT_NE(dialog, nullptr);
        list = dialog->findChild<QTreeWidget*>("keys-list");
        recorder = dialog->findChild<QKeySequenceEdit*>("new-key");
        trouble = dialog->findChild<QLabel*>("key-conflict");
    }
    [[nodiscard]] QPushButton* button(const char* id) { return dialog->findChild<QPushButton*>(id); }
    [[nodiscard]] QTreeWidgetItem* item(const char* id)
    {
        return list->topLevelItem(static_cast<int>(keys().commands().indexOf(&action(id))));
    }

    KeysDialog* dialog = nullptr;
    QTreeWidget* list = nullptr;
    QKeySequenceEdit* recorder = nullptr;
    QLabel* trouble = nullptr;
};

TEST_F(KeysDialogTest, ListsEveryCommandWithItsKeys)
{
    ASSERT_EQ(list->topLevelItemCount(), keys().commands().size());
    for (const ActionInfo& info : actionList()) {
        EXPECT_EQ(item(info.id)->text(0), plainTextOf(action(info.id))) << info.id;
        for (const QKeySequence& key : info.shortcuts)
            EXPECT_TRUE(item(info.id)->text(2).contains(key.toString(QKeySequence::NativeText))) << info.id;
    }
}

TEST_F(KeysDialogTest, FindsActionsByWordsAndByKeys)
{
    auto* filter = dialog->findChild<QLineEdit*>("keys-filter");
    filter->setText("ctrl+shift+z");
    EXPECT_FALSE(item("edit.redo")->isHidden());
    EXPECT_TRUE(item("view.fit")->isHidden());
    filter->setText("lines knot");
    EXPECT_FALSE(item("view.knots")->isHidden());
    EXPECT_TRUE(item("edit.redo")->isHidden());
}

TEST_F(KeysDialogTest, AFreeKeyIsUsed)
{
    list->setCurrentItem(item("view.knots"));
    EXPECT_FALSE(button("use-key")->isEnabled());
    QTest::keyClick(recorder, Qt::Key_L, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_TRUE(button("use-key")->isEnabled());
    EXPECT_TRUE(trouble->text().isEmpty());
    button("use-key")->click();
    EXPECT_EQ(item("view.knots")->text(2), "Ctrl+Alt+L");
    EXPECT_TRUE(item("view.knots")->font(2).bold());
    button("reset-key")->click();
    EXPECT_EQ(item("view.knots")->text(2), "K");
    button("no-key")->click();
    EXPECT_EQ(item("view.knots")->text(2), "");
    button("reset-all-keys")->click();
    EXPECT_EQ(item("view.knots")->text(2), "K");
}

TEST_F(KeysDialogTest, ATakenKeyIsTakenOnlyWhenAsked)
{
    list->setCurrentItem(item("view.knots"));
    QTest::keyClick(recorder, Qt::Key_F);
    EXPECT_TRUE(trouble->text().contains("Fit all")) << trouble->text().toStdString();
    EXPECT_FALSE(button("use-key")->isEnabled());
    button("leave-key")->click();
    EXPECT_TRUE(trouble->text().isEmpty());
    EXPECT_EQ(action("view.fit").shortcut(), QKeySequence("F"));

    QTest::keyClick(recorder, Qt::Key_F);
    button("take-key")->click();
    EXPECT_EQ(item("view.knots")->text(2), "F");
    EXPECT_EQ(item("view.fit")->text(2), "");

    list->setCurrentItem(item("view.fit"));
    button("reset-key")->click();  // its own is another's now
    EXPECT_TRUE(trouble->text().contains("Knot lines"));
    EXPECT_EQ(item("view.fit")->text(2), "");
    button("take-key")->click();
    EXPECT_EQ(item("view.fit")->text(2), "F");
    EXPECT_EQ(item("view.knots")->text(2), "");
}

TEST_F(KeysDialogTest, AMenusKeyCannotBeTaken)
{
    list->setCurrentItem(item("view.knots"));
    recorder->setKeySequence(QKeySequence("Alt+F"));
    EXPECT_TRUE(trouble->text().contains("File"));
    EXPECT_TRUE(button("take-key")->isHidden());
    EXPECT_FALSE(button("use-key")->isEnabled());
}

TEST_F(KeysDialogTest, TheMouseListFollowsTheChosenNavigation)
{
    auto* navigation = dialog->findChild<QComboBox*>("navigation");
    const auto* mouse = dialog->findChild<QTextBrowser*>("mouse-list");
    ASSERT_EQ(static_cast<size_t>(navigation->count()), navigationPresets().size());
    for (const NavigationPreset& preset : navigationPresets()) {
        window->viewport().setNavigation(preset);
        for (const MouseInfo& row : mouseList(preset)) {
            EXPECT_FALSE(row.gesture.isEmpty() || row.meaning.isEmpty()) << preset.name;
            EXPECT_TRUE(mouse->toPlainText().contains(row.gesture)) << row.gesture.toStdString();
        }
    }
    EXPECT_EQ(navigation->currentIndex(), navigation->count() - 1);
    EXPECT_TRUE(mouse->toPlainText().contains("Alt + right drag"));
    navigation->setCurrentIndex(1);
    Q_EMIT navigation->activated(1);
    EXPECT_STREQ(window->viewport().navigation().name, "rhino");
    EXPECT_TRUE(window->action("view.navigateRhino")->isChecked());
    EXPECT_FALSE(mouse->toPlainText().contains("Alt + right drag"));
    reopen();
    EXPECT_STREQ(window->viewport().navigation().name, "rhino");
}

}  // namespace
}  // namespace knotspan
