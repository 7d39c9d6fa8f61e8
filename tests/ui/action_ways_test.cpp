// Every command by each way there is: its entry in a menu under the mouse, its key, and the palette; on an
// empty document and on one where everything is possible. The list is walked, so that none can be forgotten.
#include <gtest/gtest.h>

#include <QAction>
#include <QLineEdit>
#include <QListView>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include "tests/ui/trimmed_object.h"
#include "tests/ui/window_harness.h"
#include "ui/command_model.h"
#include "ui/command_palette.h"
#include "ui/document_files.h"
#include "ui/speed_dialog.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

QMenu* menuWith(const QList<QAction*>& entries, const QAction* wanted)
{
    for (QAction* entry : entries)
        if (QMenu* menu = entry->menu()) {
            if (menu->actions().contains(wanted))
                return menu;
            if (QMenu* inside = menuWith(menu->actions(), wanted))
                return inside;
        }
    return nullptr;
}

class ActionWays : public ::testing::TestWithParam<bool> {
protected:
    void SetUp() override
    {
        answers.filesToOpen = {QString::fromStdString(file.string())};
        answers.fileToSave = QString::fromStdString((folder / "saved.knotspan").string());
        window->resize(820, 460);
        makeReady();
    }
    void TearDown() override { QSettings().clear(); }

    // The same document for each action, no dialog, and the window before all others.
    void makeReady()
    {
        for (SpeedDialog* dialog : window->findChildren<SpeedDialog*>())
            dialog->findChild<QPushButton*>("cancel")->click();
        for (QDialog* dialog : window->findChildren<QDialog*>())
            dialog->close();
        window->viewport().cancelDrag();
        window->selection().clear();
        if (GetParam())
            fill();
        else
            window->document().reset({}, "Empty");
        window->show();
        window->activateWindow();
        QApplication::setActiveWindow(window.get());
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    // Read from a file, with a selection that is trimmed, something hidden, something locked, a step to undo
    // and one to redo.
    void fill()
    {
        Document& document = window->document();
        ASSERT_TRUE(document.open(file));
        auto object = document.scene().objects().begin();
        const ObjectId selected = object->first;
        Edit edit;
        edit.set(selected, trimmedToATriangle(*object->second));
        auto hidden = std::make_shared<SceneObject>(*(++object)->second);
        hidden->visible = false;
        edit.set(object->first, std::move(hidden));
        auto locked = std::make_shared<SceneObject>(*(++object)->second);
        locked->locked = true;
        edit.set(object->first, std::move(locked));
        document.apply(edit, "Hide and lock");
        Edit removal;
        removal.set(selected, nullptr);
        document.apply(removal, "Remove");
        document.undo();
        window->selection().setObjects({selected});
        window->selection().setPoints(pointOf(document.scene(), {selected, {1, 1}}));
        Frame frame = window->viewport().frame();
        frame.path = PathId::cpu;  // which has actions of its own
        window->viewport().setFrame(frame);
    }

    // Does what `way` does with each command; it is triggered once where it is possible, else not at all.
    template <class Way>
    void walk(const Way& way)
    {
        int triggered = 0;
        for (QAction* command : window->commands()) {
            SCOPED_TRACE(command->objectName().toStdString());
            makeReady();
            const bool isPossible = command->isEnabled();
            if (GetParam()) {
                EXPECT_TRUE(isPossible);
            }
            int heard = 0;
            const auto hearing = QObject::connect(command, &QAction::triggered, [&] { ++heard; });
            way(*command);
            QCoreApplication::processEvents();
            QObject::disconnect(hearing);
            EXPECT_EQ(heard, isPossible ? 1 : 0);
            triggered += heard;
            while (window->files().isReading())
                QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
        }
        EXPECT_GT(triggered, GetParam() ? 80 : 40);
    }
    [[nodiscard]] QMenu& openMenu(QAction& command)
    {
        QMenu* menu = menuWith(window->menuBar()->actions(), &command);
        EXPECT_NE(menu, nullptr);
        menu->popup({0, 0});
        menu->setActiveAction(&command);  // a long menu scrolls to it
        return *menu;
    }

    TemporaryFolder folder;
    std::filesystem::path file = sampleFile(folder, "nine-16");
    Answers answers;
    std::unique_ptr<MainWindow> window = std::make_unique<MainWindow>(answering(answers));
};

TEST_P(ActionWays, EachByTheMouseInItsMenu)
{
    walk([this](QAction& command) {
        QMenu& menu = openMenu(command);
        QTest::mouseClick(&menu, Qt::LeftButton, {}, menu.actionGeometry(&command).center());
        menu.close();
    });
}

// Those without a key of their own by Enter in their menu.
TEST_P(ActionWays, EachByTheKeyboard)
{
    walk([this](QAction& command) {
        if (!command.shortcut().isEmpty()) {
            QTest::keySequence(window.get(), command.shortcut());
            return;
        }
        QMenu& menu = openMenu(command);
        QTest::keyClick(&menu, Qt::Key_Return);
        menu.close();
    });
}

TEST_P(ActionWays, EachByThePalette)
{
    walk([this](QAction& command) {
        const bool isPalette = command.objectName() == "help.palette";
        if (!isPalette)
            window->action("help.palette")->trigger();
        else
            QTest::keySequence(window.get(), command.shortcut());  // what brings it up is its way in
        auto* palette = window->findChild<CommandPalette*>();
        ASSERT_NE(palette, nullptr);
        if (isPalette)
            return;
        auto* filter = palette->findChild<QLineEdit*>();
        auto* list = palette->findChild<QListView*>();
        filter->setText(command.objectName());
        const auto& model = dynamic_cast<const CommandModel&>(*list->model());
        for (int k = 0; k < model.rowCount() && model.command(list->currentIndex().row()) != &command; ++k)
            QTest::keyClick(filter, Qt::Key_Down);
        ASSERT_EQ(model.command(list->currentIndex().row()), &command);
        QTest::keyClick(filter, Qt::Key_Return);
    });
}

INSTANTIATE_TEST_SUITE_P(All, ActionWays, ::testing::Values(false, true), [](const auto& instance) {
    return instance.param ? "FullDocument" : "EmptyDocument";
});

}  // namespace
}  // namespace knotspan
