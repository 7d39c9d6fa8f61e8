// Every key does what its row of the list of actions says: pressed, not only written there.
#include <set>

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QSettings>
#include <QTest>

#include "tests/ui/trimmed_object.h"
#include "tests/ui/window_harness.h"
#include "ui/actions.h"
#include "ui/document_files.h"

namespace knotspan {
namespace {

using namespace knotspan::testing;

// So that there are loops to take away.
void trim(Document& document, ObjectId id)
{
    Edit edit;
    edit.set(id, trimmedToATriangle(*document.scene().find(id)));
    document.apply(edit, "Trim");
}

// Objects, control points, a step to take back: what actions ask for.
void makeReady(MainWindow& window)
{
    for (QDialog* dialog : window.findChildren<QDialog*>())
        dialog->close();
    const Scene& scene = window.document().scene();
    if (scene.objects().empty())
        window.files().openSample("nine-16");
    const ObjectId id = window.document().scene().objects().begin()->first;
    window.selection().setObjects({id});
    window.selection().setPoints(pointOf(window.document().scene(), {id, {1, 1}}));
    window.activateWindow();
    QApplication::setActiveWindow(&window);
    QCoreApplication::processEvents();
}

TEST(ActionKeys, EachTriggersItsAction)
{
    Answers answers;
    const auto window = shownWindow(answers, "nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    // One closes the window, one draws for a minute; the others wait for a state of their own.
    const std::set<std::string> left{"file.quit",      "view.speed",      "edit.redo",
                                     "edit.undo",      "object.showAll",  "object.unlockAll",
                                     "view.moreCells", "view.fewerCells", "file.reload"};
    int pressed = 0;
    for (const ActionInfo& info : actionList()) {
        if (left.count(info.id) != 0)
            continue;
        for (const QKeySequence& keys : info.shortcuts) {
            makeReady(*window);
            if (QString(info.id) == "edit.untrim")
                trim(window->document(), *window->selection().objects().begin());
            QAction* action = window->action(info.id);
            ASSERT_TRUE(action->isEnabled()) << info.id;
            int triggered = 0;
            const auto heard = QObject::connect(action, &QAction::triggered, [&] { ++triggered; });
            QTest::keySequence(window.get(), keys);
            QObject::disconnect(heard);
            EXPECT_EQ(triggered, 1) << info.id << " by " << keys.toString().toStdString();
            ++pressed;
        }
    }
    EXPECT_GT(pressed, 60);
    QSettings().clear();  // of snapping and the like: other tests begin as a new user does
}

TEST(ActionKeys, UndoAndRedoTakeTheirSteps)
{
    Answers answers;
    const auto window = shownWindow(answers, "nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    const Scene start = window->document().scene();
    const auto press = [&](const char* id) {
        window->activateWindow();
        QApplication::setActiveWindow(window.get());
        QTest::keySequence(window.get(), window->action(id)->shortcut());
    };
    makeReady(*window);
    press("object.lock");
    press("object.unlockAll");
    EXPECT_EQ(window->document().history().count(), 2);
    EXPECT_TRUE(window->document().scene() == start);
    makeReady(*window);
    press("object.hide");
    EXPECT_FALSE(window->document().scene() == start);
    press("edit.undo");
    EXPECT_TRUE(window->document().scene() == start);
    press("edit.redo");
    EXPECT_FALSE(window->document().scene() == start);
    press("object.showAll");
    EXPECT_TRUE(window->document().scene() == start);
}

TEST(ActionKeys, IsolateHidesTheOthersAndViewSwitchesChangeThePicture)
{
    Answers answers;
    const auto window = shownWindow(answers, "nine-16");
    KNOTSPAN_NEED_RENDERER(*window);
    makeReady(*window);
    window->action("object.isolate")->trigger();
    int visible = 0;
    for (const auto& [id, object] : window->document().scene().objects())
        visible += object->visible ? 1 : 0;
    EXPECT_EQ(visible, 1);
    EXPECT_EQ(window->document().history().count(), 1);
    for (const char* id :
         {"view.points", "view.hulls", "view.isoCurves", "view.normals", "view.knots", "view.outlines"}) {
        settle(*window);
        const QImage before = picture(*window);
        window->action(id)->trigger();
        settle(*window);
        EXPECT_GT(differingPixels(before, picture(*window)), 20) << id;
    }
    EXPECT_EQ(window->document().history().count(), 1);
}

}  // namespace
}  // namespace knotspan
